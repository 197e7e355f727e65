(define (problem rushhour-middle) (:domain rush)
  (:objects
    carA carO carP carQ carX carB carC carR - car c0-0 c0-1 c0-2 c0-3 c0-4 c0-5 c1-0 c1-1 c1-2 c1-3 c1-4 c1-5 c2-0
    c2-1 c2-2 c2-3 c2-4 c2-5 c3-0 c3-1 c3-2 c3-3 c3-4 c3-5 c4-0 c4-1 c4-2 c4-3 c4-4 c4-5 c5-0 c5-1 c5-2 c5-3 c5-4
    c5-5 - cell)
  (:init
    (free c2-0) (free c3-0) (free c4-0) (free c1-1) (free c2-1) (free c4-1) (free c4-2) (free c1-3) (free c2-3)
    (free c4-3) (free c5-3) (free c1-4) (free c2-4) (free c3-4) (free c1-5) (free c5-5) (at2 carA c0-0 c1-0)
    (h2 carA c0-0 c1-0 c2-0) (h2 carA c1-0 c2-0 c3-0) (h2 carA c2-0 c3-0 c4-0) (h2 carA c3-0 c4-0 c5-0)
    (at3 carO c5-0 c5-1 c5-2) (h3 carO c5-0 c5-1 c5-2 c5-3) (h3 carO c5-1 c5-2 c5-3 c5-4)
    (h3 carO c5-2 c5-3 c5-4 c5-5) (at3 carP c0-1 c0-2 c0-3) (h3 carP c0-0 c0-1 c0-2 c0-3)
    (h3 carP c0-1 c0-2 c0-3 c0-4) (h3 carP c0-2 c0-3 c0-4 c0-5) (at3 carQ c3-1 c3-2 c3-3)
    (h3 carQ c3-0 c3-1 c3-2 c3-3) (h3 carQ c3-1 c3-2 c3-3 c3-4) (h3 carQ c3-2 c3-3 c3-4 c3-5) (at2 carX c1-2 c2-2)
    (h2 carX c0-2 c1-2 c2-2) (h2 carX c1-2 c2-2 c3-2) (h2 carX c2-2 c3-2 c4-2) (h2 carX c3-2 c4-2 c5-2)
    (at2 carB c0-4 c0-5) (h2 carB c0-0 c0-1 c0-2) (h2 carB c0-1 c0-2 c0-3) (h2 carB c0-2 c0-3 c0-4)
    (h2 carB c0-3 c0-4 c0-5) (at2 carC c4-4 c5-4) (h2 carC c0-4 c1-4 c2-4) (h2 carC c1-4 c2-4 c3-4)
    (h2 carC c2-4 c3-4 c4-4) (h2 carC c3-4 c4-4 c5-4) (at3 carR c2-5 c3-5 c4-5) (h3 carR c0-5 c1-5 c2-5 c3-5)
    (h3 carR c1-5 c2-5 c3-5 c4-5) (h3 carR c2-5 c3-5 c4-5 c5-5))
  (:goal (at2 carX c4-2 c5-2)))
