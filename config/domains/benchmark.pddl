; The rules of the symbolic simulator in which the demonstrations were recorded, to the letter and with its oddities:
; scores on the benchmark only mean something under these rules. What a robot can really do is in household.pddl.
;
; Facts keep the names of the data: (state SinkKnob TapIsOn), (Near Robot Mug_1), (On Mug_1 Sink), ...
; Oddities kept on purpose: nothing limits how much is held; "Near" accumulates; putting something down does not
; say where it stood before; the microwave heats what it is inside of (its arguments are swapped in the original);
; burners are objects (StoveFire_1) and also values (StoveFire1), and only the latter heat.
(define (domain goalnet-benchmark)
  (:requirements :adl)

  (:types
    thing robot part value - object
    compartment button knob door scoop - part
    content flame - value
    pourable - content)

  (:constants
    Robot - robot
    ; things that actions name
    Sink SinkKnob Stove Microwave Fridge Tv_1 Tv_1Remote_1 Xbox_1 Spoon_1 Fork_1 Salt_1 Ramen_1 BoiledEgg_1
    BagOfChips_1 GarbageBag_1 GarbageBin_1 - thing
    FridgeLeft FridgeRight - compartment
    FridgeLeftDoor FridgeRightDoor - door
    StoveKnob_1 StoveKnob_2 StoveKnob_3 StoveKnob_4 - knob
    MicrowaveButton FridgeButton
    Tv_1PowerButton Tv_1ChannelUpButton Tv_1ChannelDownButton Tv_1VolumeUpButton Tv_1VolumeDownButton
    Tv_1Remote_1PowerButton Tv_1Remote_1ChannelUpButton Tv_1Remote_1ChannelDownButton
    Tv_1Remote_1VolumeUpButton Tv_1Remote_1VolumeDownButton Tv_1Remote_1MuteButton - button
    IceCreamScoop - scoop
    ; values of states
    Water Coffee Coke EnergyDrink IceCream Chocolate CanadaDry Vanilla Salt - pourable
    Ramen Egg - content
    StoveFire1 StoveFire2 StoveFire3 StoveFire4 - flame
    TapIsOn temperatureHigh IsOn IsOpen DoorIsOpen MicrowaveIsOn LeftDoorIsOpen RightDoorIsOpen WaterDispenserIsOpen
    Channel1 Channel2 Channel3 Channel4 Channel5 Channel6 Volume ScoopsLeft HasChips CD Fork spoon - value)

  (:predicates
    (state ?o - thing ?v - value)
    (Near ?a - (either robot thing) ?b - (either thing robot))
    (On ?a - thing ?b - (either thing flame))
    (In ?a - thing ?b - (either thing compartment))
    (Grasping ?r - robot ?o - thing)
    (IsGraspable ?o - thing)
    (IsSqueezeable ?o - thing))

  (:action moveto
    :parameters (?o - thing)
    :precondition ()
    :effect (and
      (Near Robot ?o)
      (forall (?x - thing)
        (when (and (not (= ?x ?o)) (not (Grasping Robot ?x))) (not (Near ?o ?x))))))

  (:action grasp
    :parameters (?o - thing)
    :precondition (and (IsGraspable ?o) (Near Robot ?o) (not (Grasping Robot ?o)))
    :effect (and
      (Grasping Robot ?o)
      (not (Near Robot ?o))
      (forall (?x - thing)
        (when (not (= ?x ?o))
          (and (not (In ?o ?x)) (not (On ?o ?x)) (not (Near ?o ?x))
               (not (In ?x ?o)) (not (On ?x ?o)) (not (Near ?x ?o)))))
      (forall (?f - flame) (not (On ?o ?f)))
      (forall (?c - compartment) (not (In ?o ?c)))))

  (:action release
    :parameters (?o - thing)
    :precondition (Grasping Robot ?o)
    :effect (not (Grasping Robot ?o)))

  (:action keep-on
    :parameters (?x - thing ?z - (either thing flame))
    :precondition (and
      (Grasping Robot ?x)
      (imply (or (= ?z StoveFire1) (= ?z StoveFire2) (= ?z StoveFire3) (= ?z StoveFire4)) (Near Robot Stove))
      (or (= ?z StoveFire1) (= ?z StoveFire2) (= ?z StoveFire3) (= ?z StoveFire4) (Near Robot ?z)))
    :effect (and
      (not (Grasping Robot ?x))
      (On ?x ?z)
      (when (and (= ?z Sink) (state SinkKnob TapIsOn)) (and (state ?x Water) (not (state ?x temperatureHigh))))
      (when (and (= ?z StoveFire1) (state Stove StoveFire1)) (state ?x temperatureHigh))
      (when (and (= ?z StoveFire2) (state Stove StoveFire2)) (state ?x temperatureHigh))
      (when (and (= ?z StoveFire3) (state Stove StoveFire3)) (state ?x temperatureHigh))
      (when (and (= ?z StoveFire4) (state Stove StoveFire4)) (state ?x temperatureHigh))))

  (:action keep-in
    :parameters (?x - thing ?z - (either thing compartment))
    :precondition (and
      (Grasping Robot ?x)
      (imply (= ?z Microwave) (state Microwave DoorIsOpen))
      (imply (= ?z FridgeLeft) (and (Near Robot Fridge) (state Fridge LeftDoorIsOpen)))
      (imply (= ?z FridgeRight) (and (Near Robot Fridge) (state Fridge RightDoorIsOpen)))
      (imply (= ?z GarbageBag_1) (Grasping Robot GarbageBag_1))
      (or (= ?z FridgeLeft) (= ?z FridgeRight) (= ?z GarbageBag_1) (Near Robot ?z)))
    :effect (and (not (Grasping Robot ?x)) (In ?x ?z)))

  (:action keep-near
    :parameters (?x - thing ?z - thing)
    :precondition (and (Grasping Robot ?x) (Near Robot ?z))
    :effect (and (not (Grasping Robot ?x)) (Near ?x ?z)))

  (:action turn
    :parameters (?k - (either thing knob))
    :precondition (or
      (and (= ?k SinkKnob) (Near Robot Sink))
      (and (or (= ?k StoveKnob_1) (= ?k StoveKnob_2) (= ?k StoveKnob_3) (= ?k StoveKnob_4)) (Near Robot Stove)))
    :effect (and
      (when (and (= ?k SinkKnob) (state SinkKnob TapIsOn)) (not (state SinkKnob TapIsOn)))
      (when (and (= ?k SinkKnob) (not (state SinkKnob TapIsOn)))
        (and (state SinkKnob TapIsOn) (forall (?x - thing) (when (On ?x Sink) (state ?x Water)))))
      (when (and (= ?k StoveKnob_1) (state Stove StoveFire1)) (not (state Stove StoveFire1)))
      (when (and (= ?k StoveKnob_1) (not (state Stove StoveFire1)))
        (and (state Stove StoveFire1) (forall (?x - thing) (when (On ?x StoveFire1) (state ?x temperatureHigh)))))
      (when (and (= ?k StoveKnob_2) (state Stove StoveFire2)) (not (state Stove StoveFire2)))
      (when (and (= ?k StoveKnob_2) (not (state Stove StoveFire2)))
        (and (state Stove StoveFire2) (forall (?x - thing) (when (On ?x StoveFire2) (state ?x temperatureHigh)))))
      (when (and (= ?k StoveKnob_3) (state Stove StoveFire3)) (not (state Stove StoveFire3)))
      (when (and (= ?k StoveKnob_3) (not (state Stove StoveFire3)))
        (and (state Stove StoveFire3) (forall (?x - thing) (when (On ?x StoveFire3) (state ?x temperatureHigh)))))
      (when (and (= ?k StoveKnob_4) (state Stove StoveFire4)) (not (state Stove StoveFire4)))
      (when (and (= ?k StoveKnob_4) (not (state Stove StoveFire4)))
        (and (state Stove StoveFire4) (forall (?x - thing) (when (On ?x StoveFire4) (state ?x temperatureHigh)))))))

  (:action press
    :parameters (?b - button)
    :precondition (or
      (and (= ?b MicrowaveButton) (Near Robot Microwave))
      (and (= ?b FridgeButton) (Near Robot Fridge))
      (and (or (= ?b Tv_1PowerButton) (= ?b Tv_1ChannelUpButton) (= ?b Tv_1ChannelDownButton)
               (= ?b Tv_1VolumeUpButton) (= ?b Tv_1VolumeDownButton) (= ?b Tv_1Remote_1MuteButton))
           (Near Robot Tv_1))
      (and (or (= ?b Tv_1Remote_1PowerButton) (= ?b Tv_1Remote_1ChannelUpButton)
               (= ?b Tv_1Remote_1ChannelDownButton) (= ?b Tv_1Remote_1VolumeUpButton)
               (= ?b Tv_1Remote_1VolumeDownButton))
           (Grasping Robot Tv_1Remote_1)))
    :effect (and
      (when (and (= ?b MicrowaveButton) (state Microwave MicrowaveIsOn)) (not (state Microwave MicrowaveIsOn)))
      (when (and (= ?b MicrowaveButton) (not (state Microwave MicrowaveIsOn)))
        (and (state Microwave MicrowaveIsOn)
             (forall (?x - thing) (when (In Microwave ?x) (state ?x temperatureHigh)))))
      (when (and (= ?b FridgeButton) (state Fridge WaterDispenserIsOpen)) (not (state Fridge WaterDispenserIsOpen)))
      (when (and (= ?b FridgeButton) (not (state Fridge WaterDispenserIsOpen)))
        (and (state Fridge WaterDispenserIsOpen)
             (forall (?x - thing) (when (Grasping Robot ?x) (state ?x Water)))))
      (when (or (= ?b Tv_1PowerButton) (= ?b Tv_1Remote_1PowerButton))
        (and (when (state Tv_1 IsOn) (not (state Tv_1 IsOn)))
             (when (not (state Tv_1 IsOn)) (state Tv_1 IsOn))))
      (when (and (state Tv_1 IsOn) (or (= ?b Tv_1VolumeUpButton) (= ?b Tv_1Remote_1VolumeUpButton)))
        (state Tv_1 Volume))
      (when (and (state Tv_1 IsOn)
                 (or (= ?b Tv_1VolumeDownButton) (= ?b Tv_1Remote_1VolumeDownButton) (= ?b Tv_1Remote_1MuteButton)))
        (not (state Tv_1 Volume)))
      (when (and (state Tv_1 IsOn) (or (= ?b Tv_1ChannelUpButton) (= ?b Tv_1Remote_1ChannelUpButton)))
        (and (when (state Tv_1 Channel1) (and (not (state Tv_1 Channel1)) (state Tv_1 Channel2)))
             (when (state Tv_1 Channel2) (and (not (state Tv_1 Channel2)) (state Tv_1 Channel3)))
             (when (state Tv_1 Channel3) (and (not (state Tv_1 Channel3)) (state Tv_1 Channel4)))
             (when (state Tv_1 Channel4) (and (not (state Tv_1 Channel4)) (state Tv_1 Channel5)))
             (when (state Tv_1 Channel5) (and (not (state Tv_1 Channel5)) (state Tv_1 Channel6)))
             (when (state Tv_1 Channel6) (and (not (state Tv_1 Channel6)) (state Tv_1 Channel1)))))
      (when (and (state Tv_1 IsOn) (or (= ?b Tv_1ChannelDownButton) (= ?b Tv_1Remote_1ChannelDownButton)))
        (and (when (state Tv_1 Channel1) (and (not (state Tv_1 Channel1)) (state Tv_1 Channel6)))
             (when (state Tv_1 Channel2) (and (not (state Tv_1 Channel2)) (state Tv_1 Channel1)))
             (when (state Tv_1 Channel3) (and (not (state Tv_1 Channel3)) (state Tv_1 Channel2)))
             (when (state Tv_1 Channel4) (and (not (state Tv_1 Channel4)) (state Tv_1 Channel3)))
             (when (state Tv_1 Channel5) (and (not (state Tv_1 Channel5)) (state Tv_1 Channel4)))
             (when (state Tv_1 Channel6) (and (not (state Tv_1 Channel6)) (state Tv_1 Channel5)))))))

  (:action open
    :parameters (?d - (either thing door))
    :precondition (or
      (and (= ?d Microwave) (Near Robot Microwave) (not (state Microwave DoorIsOpen)))
      (and (= ?d FridgeLeftDoor) (Near Robot Fridge) (not (state Fridge LeftDoorIsOpen)))
      (and (= ?d FridgeRightDoor) (Near Robot Fridge) (not (state Fridge RightDoorIsOpen)))
      (and (= ?d BagOfChips_1) (Grasping Robot BagOfChips_1)))
    :effect (and
      (when (= ?d Microwave) (and (state Microwave DoorIsOpen) (not (state Microwave MicrowaveIsOn))))
      (when (= ?d FridgeLeftDoor) (and (state Fridge LeftDoorIsOpen) (not (state Fridge WaterDispenserIsOpen))))
      (when (= ?d FridgeRightDoor) (state Fridge RightDoorIsOpen))
      (when (= ?d BagOfChips_1) (state BagOfChips_1 IsOpen))))

  (:action close
    :parameters (?d - (either thing door))
    :precondition (or
      (and (= ?d Microwave) (Near Robot Microwave) (state Microwave DoorIsOpen))
      (and (= ?d FridgeLeftDoor) (Near Robot Fridge) (state Fridge LeftDoorIsOpen))
      (and (= ?d FridgeRightDoor) (Near Robot Fridge) (state Fridge RightDoorIsOpen)))
    :effect (and
      (when (= ?d Microwave) (not (state Microwave DoorIsOpen)))
      (when (= ?d FridgeLeftDoor) (not (state Fridge LeftDoorIsOpen)))
      (when (= ?d FridgeRightDoor) (not (state Fridge RightDoorIsOpen)))))

  (:action pour-out
    :parameters (?x - thing)
    :precondition (Grasping Robot ?x)
    :effect (forall (?c - content) (not (state ?x ?c))))

  (:action pour
    :parameters (?x - thing ?y - thing)
    :precondition (and (Grasping Robot ?x) (Grasping Robot ?y))
    :effect (forall (?c - pourable) (when (state ?x ?c) (state ?y ?c))))

  (:action add
    :parameters (?what - (either thing scoop) ?x - thing)
    :precondition (or
      (and (or (= ?what Salt_1) (= ?what Ramen_1) (= ?what BoiledEgg_1))
           (Grasping Robot ?what) (Grasping Robot ?x))
      (and (= ?what IceCreamScoop) (Grasping Robot Spoon_1) (state Spoon_1 ScoopsLeft)))
    :effect (and
      (when (= ?what Salt_1) (state ?x Salt))
      (when (= ?what Ramen_1) (and (state ?x Ramen) (not (Grasping Robot Ramen_1)) (In Ramen_1 ?x)))
      (when (= ?what BoiledEgg_1) (and (state ?x Egg) (not (Grasping Robot BoiledEgg_1)) (In BoiledEgg_1 ?x)))
      (when (= ?what IceCreamScoop) (and (state ?x IceCream) (not (state Spoon_1 ScoopsLeft))))))

  (:action squeeze
    :parameters (?x - thing ?y - thing)
    :precondition (and (Grasping Robot ?x) (Grasping Robot ?y) (IsSqueezeable ?x))
    :effect (when (state ?x Chocolate) (state ?y Chocolate)))

  (:action scoop
    :parameters (?x - thing ?y - thing)
    :precondition (and (Grasping Robot ?x) (Grasping Robot ?y) (state ?y ScoopsLeft))
    :effect (state ?x ScoopsLeft))

  (:action place
    :parameters (?u - thing ?y - thing)
    :precondition (and (or (= ?u Fork_1) (= ?u Spoon_1)) (Grasping Robot ?y))
    :effect (and
      (not (Grasping Robot ?y))
      (In ?u ?y)
      (when (= ?u Fork_1) (state ?y Fork))
      (when (= ?u Spoon_1) (state ?y spoon))))

  (:action insert
    :parameters (?x - thing ?y - thing)
    :precondition (and (state ?x CD) (Grasping Robot ?x) (Grasping Robot ?y))
    :effect (and (state ?y CD) (not (Grasping Robot ?x)) (In ?x ?y))))
