(define (problem childsnack-small) (:domain child-snack)
  (:objects child0 child1 child2 - child bread0 bread1 bread2 - bread-portion content0 content1 content2 - content-portion tray0 - tray table1 table2 table3 - place sandw0 sandw1 sandw2 sandw3 - sandwich)
  (:init
    (at tray0 kitchen) (at_kitchen_bread bread0) (at_kitchen_content content0) (no_gluten_bread bread0)
    (no_gluten_content content0) (allergic_gluten child0) (waiting child0 table3) (at_kitchen_bread bread1)
    (at_kitchen_content content1) (not_allergic_gluten child1) (waiting child1 table2) (at_kitchen_bread bread2)
    (at_kitchen_content content2) (not_allergic_gluten child2) (waiting child2 table1) (notexist sandw0)
    (notexist sandw1) (notexist sandw2) (notexist sandw3))
  (:goal (and
    (served child0) (served child1) (served child2))))
