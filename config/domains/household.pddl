; What the robot can physically do at home: two grippers and a tray, doors that must be open, toggles split into on
; and off, contents that move when poured, a microwave that heats behind its closed door.
;
; "Grasping" means held in a hand or standing on the tray. Which hand is the robot's business: the world says
; (Held Mug_1 LeftHand); the domain only asks for (Held Mug_1 Tray) and counts. HandsHold and TrayHolds are
; bookkeeping: they are computed from the facts when a problem is made and never leave the planner.
; Near is pessimistic: going to one thing forgets all others, although the robot may still stand beside them.
(define (domain goalnet-household)
  (:requirements :adl :action-costs)

  (:types
    thing robot part value holder count - object
    surface container appliance item - thing
    vessel dish ingredient utensil bottle tub - item
    compartment button knob door scoop - part
    content - value
    pourable - content)

  (:constants
    Robot - robot
    LeftHand RightHand Tray - holder
    Zero One Two Three Four - count
    ; fixtures and furniture
    Sink Counter_1 StoveFire_1 StoveFire_2 StoveFire_3 StoveFire_4 CoffeeTable_1 SnackTable_1 Studytable_1 Shelf_1
    Shelf_2 Loveseat_1 Loveseat_2 Armchair_1 Armchair_2 Armchair_3 Armchair_4 - surface
    Microwave GarbageBin_1 GarbageBag_1 - container
    Fridge Stove Tv_1 Xbox_1 SinkKnob - appliance
    ; things with a part in some rule
    Mug_1 Kettle Glass_1 LongCup_1 LongCup_2 Bowl_1 InstantRamen_1 - vessel
    EnergyDrink_1 Coke_1 CanadaDry_1 - vessel
    Plate_1 Plate_2 - dish
    Ramen_1 BoiledEgg_1 Salt_1 - ingredient
    Spoon_1 Fork_1 - utensil
    Syrup_1 Syrup_2 - bottle
    IceCream_1 - tub
    Tv_1Remote_1 BagOfChips_1 Cd_1 Cd_2 - item
    ; parts
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
    TapIsOn temperatureHigh IsOn IsOpen DoorIsOpen MicrowaveIsOn LeftDoorIsOpen RightDoorIsOpen WaterDispenserIsOpen
    StoveFire1 StoveFire2 StoveFire3 StoveFire4
    Channel1 Channel2 Channel3 Channel4 Channel5 Channel6 Volume ScoopsLeft HasChips CD Fork spoon - value)

  (:predicates
    (Unfit ?o - thing ?where - (either thing compartment))   ; too large for it, whatever is done
    (state ?o - thing ?v - value)
    (Near ?a - (either robot thing) ?b - thing)
    (On ?a - thing ?b - thing)
    (In ?a - thing ?b - (either thing compartment))
    (Grasping ?r - robot ?o - thing)
    (Held ?o - thing ?h - holder)
    (IsGraspable ?o - thing)
    (IsSqueezeable ?o - thing)
    (HandsHold ?n - count)   ; at most Two
    (TrayHolds ?n - count)   ; at most Four
    (InHand ?o - thing)
    (AtHand ?o - thing))

  ; Every action costs 2. Filling at the dispenser costs more: whoever just wants water goes to the sink.
  (:functions (total-cost))

  (:derived (InHand ?o - thing) (and (Grasping Robot ?o) (not (Held ?o Tray))))
  ; Within reach of the other hand: held, on the tray, or standing nearby, but not where a hand has no room to pour or scoop.
  (:derived (AtHand ?o - thing)
    (or (Grasping Robot ?o)
        (and (Near Robot ?o) (not (In ?o Microwave)) (not (In ?o Fridge)) (not (In ?o FridgeLeft)) (not (In ?o FridgeRight)))))

  (:action moveto
    :parameters (?o - thing)
    :precondition (not (Grasping Robot ?o))
    :effect (and (increase (total-cost) 2)
      (Near Robot ?o)
      (forall (?x - thing) (when (not (= ?x ?o)) (not (Near Robot ?x))))))

  ; Out of a closed container nothing can be taken.
  (:action grasp
    :parameters (?o - thing)
    :precondition (and
      (IsGraspable ?o) (Near Robot ?o) (not (Grasping Robot ?o)) (not (HandsHold Two))
      (or (not (In ?o Microwave)) (state Microwave DoorIsOpen))
      (or (not (In ?o FridgeLeft)) (state Fridge LeftDoorIsOpen))
      (or (not (In ?o FridgeRight)) (state Fridge RightDoorIsOpen))
      ; in the fridge, but nobody knows behind which door: open both
      (or (not (In ?o Fridge)) (In ?o FridgeLeft) (In ?o FridgeRight)
          (and (state Fridge LeftDoorIsOpen) (state Fridge RightDoorIsOpen))))
    :effect (and (increase (total-cost) 2)
      (Grasping Robot ?o) (not (Near Robot ?o))
      (forall (?x - thing) (and (not (On ?o ?x)) (not (In ?o ?x)) (not (Near ?o ?x))))
      (forall (?c - compartment) (not (In ?o ?c)))
      (when (HandsHold Zero) (and (not (HandsHold Zero)) (HandsHold One)))
      (when (HandsHold One) (and (not (HandsHold One)) (HandsHold Two)))))

  (:action release
    :parameters (?o - thing)
    :precondition (InHand ?o)
    :effect (and (increase (total-cost) 2)
      (not (Grasping Robot ?o))
      (forall (?h - holder) (not (Held ?o ?h)))
      (when (HandsHold Two) (and (not (HandsHold Two)) (HandsHold One)))
      (when (HandsHold One) (and (not (HandsHold One)) (HandsHold Zero)))))

  (:action stow
    :parameters (?o - thing)
    :precondition (and (InHand ?o) (not (TrayHolds Four)))
    :effect (and (increase (total-cost) 2)
      (Held ?o Tray) (not (Held ?o LeftHand)) (not (Held ?o RightHand))
      (when (HandsHold Two) (and (not (HandsHold Two)) (HandsHold One)))
      (when (HandsHold One) (and (not (HandsHold One)) (HandsHold Zero)))
      (when (TrayHolds Zero) (and (not (TrayHolds Zero)) (TrayHolds One)))
      (when (TrayHolds One) (and (not (TrayHolds One)) (TrayHolds Two)))
      (when (TrayHolds Two) (and (not (TrayHolds Two)) (TrayHolds Three)))
      (when (TrayHolds Three) (and (not (TrayHolds Three)) (TrayHolds Four)))))

  (:action unstow
    :parameters (?o - thing)
    :precondition (and (Held ?o Tray) (not (HandsHold Two)))
    :effect (and (increase (total-cost) 2)
      (not (Held ?o Tray))
      (when (HandsHold Zero) (and (not (HandsHold Zero)) (HandsHold One)))
      (when (HandsHold One) (and (not (HandsHold One)) (HandsHold Two)))
      (when (TrayHolds Four) (and (not (TrayHolds Four)) (TrayHolds Three)))
      (when (TrayHolds Three) (and (not (TrayHolds Three)) (TrayHolds Two)))
      (when (TrayHolds Two) (and (not (TrayHolds Two)) (TrayHolds One)))
      (when (TrayHolds One) (and (not (TrayHolds One)) (TrayHolds Zero)))))

  (:action keep-on
    :parameters (?x - thing ?surface - (either surface dish))
    :precondition (and (InHand ?x) (Near Robot ?surface) (not (= ?x ?surface)) (not (Unfit ?x ?surface)))
    :effect (and (increase (total-cost) 2)
      (not (Grasping Robot ?x))
      (forall (?h - holder) (not (Held ?x ?h)))
      (On ?x ?surface)
      (when (HandsHold Two) (and (not (HandsHold Two)) (HandsHold One)))
      (when (HandsHold One) (and (not (HandsHold One)) (HandsHold Zero)))
      (forall (?v - vessel)
        (when (and (= ?surface Sink) (= ?v ?x) (state SinkKnob TapIsOn))
          (and (state ?v Water) (not (state ?v temperatureHigh)))))
      (when (and (= ?surface StoveFire_1) (state Stove StoveFire1)) (state ?x temperatureHigh))
      (when (and (= ?surface StoveFire_2) (state Stove StoveFire2)) (state ?x temperatureHigh))
      (when (and (= ?surface StoveFire_3) (state Stove StoveFire3)) (state ?x temperatureHigh))
      (when (and (= ?surface StoveFire_4) (state Stove StoveFire4)) (state ?x temperatureHigh))))

  ; What stands in a compartment of the fridge is in the fridge.
  (:action keep-in
    :parameters (?x - thing ?container - (either container compartment))
    :precondition (and
      (InHand ?x) (not (= ?x ?container)) (not (Unfit ?x ?container))
      (imply (= ?container Microwave) (state Microwave DoorIsOpen))
      (imply (= ?container FridgeLeft) (and (Near Robot Fridge) (state Fridge LeftDoorIsOpen)))
      (imply (= ?container FridgeRight) (and (Near Robot Fridge) (state Fridge RightDoorIsOpen)))
      (or (= ?container FridgeLeft) (= ?container FridgeRight) (Near Robot ?container)
          ; the other hand may hold the bag
          (and (= ?container GarbageBag_1) (InHand GarbageBag_1))))
    :effect (and (increase (total-cost) 2)
      (not (Grasping Robot ?x))
      (forall (?h - holder) (not (Held ?x ?h)))
      (In ?x ?container)
      (when (or (= ?container FridgeLeft) (= ?container FridgeRight)) (In ?x Fridge))
      (when (HandsHold Two) (and (not (HandsHold Two)) (HandsHold One)))
      (when (HandsHold One) (and (not (HandsHold One)) (HandsHold Zero)))))

  (:action turn-on
    :parameters (?knob - (either appliance knob))
    :precondition (and
      (not (HandsHold Two))
      (or (and (= ?knob SinkKnob) (Near Robot Sink) (not (state SinkKnob TapIsOn)))
          (and (= ?knob StoveKnob_1) (Near Robot Stove) (not (state Stove StoveFire1)))
          (and (= ?knob StoveKnob_2) (Near Robot Stove) (not (state Stove StoveFire2)))
          (and (= ?knob StoveKnob_3) (Near Robot Stove) (not (state Stove StoveFire3)))
          (and (= ?knob StoveKnob_4) (Near Robot Stove) (not (state Stove StoveFire4)))))
    :effect (and (increase (total-cost) 2)
      (when (= ?knob SinkKnob)
        (and (state SinkKnob TapIsOn)
             (forall (?v - vessel)
               (when (On ?v Sink) (and (state ?v Water) (not (state ?v temperatureHigh)))))))
      (when (= ?knob StoveKnob_1)
        (and (state Stove StoveFire1)
             (forall (?x - thing) (when (On ?x StoveFire_1) (state ?x temperatureHigh)))))
      (when (= ?knob StoveKnob_2)
        (and (state Stove StoveFire2)
             (forall (?x - thing) (when (On ?x StoveFire_2) (state ?x temperatureHigh)))))
      (when (= ?knob StoveKnob_3)
        (and (state Stove StoveFire3)
             (forall (?x - thing) (when (On ?x StoveFire_3) (state ?x temperatureHigh)))))
      (when (= ?knob StoveKnob_4)
        (and (state Stove StoveFire4)
             (forall (?x - thing) (when (On ?x StoveFire_4) (state ?x temperatureHigh)))))))

  (:action turn-off
    :parameters (?knob - (either appliance knob))
    :precondition (and
      (not (HandsHold Two))
      (or (and (= ?knob SinkKnob) (Near Robot Sink) (state SinkKnob TapIsOn))
          (and (= ?knob StoveKnob_1) (Near Robot Stove) (state Stove StoveFire1))
          (and (= ?knob StoveKnob_2) (Near Robot Stove) (state Stove StoveFire2))
          (and (= ?knob StoveKnob_3) (Near Robot Stove) (state Stove StoveFire3))
          (and (= ?knob StoveKnob_4) (Near Robot Stove) (state Stove StoveFire4))))
    :effect (and (increase (total-cost) 2)
      (when (= ?knob SinkKnob) (not (state SinkKnob TapIsOn)))
      (when (= ?knob StoveKnob_1) (not (state Stove StoveFire1)))
      (when (= ?knob StoveKnob_2) (not (state Stove StoveFire2)))
      (when (= ?knob StoveKnob_3) (not (state Stove StoveFire3)))
      (when (= ?knob StoveKnob_4) (not (state Stove StoveFire4)))))

  ; The dispenser is in the fridge's left door; it runs until its button is pressed again or the door is opened.
  (:action press-on
    :parameters (?button - button)
    :precondition (and
      (not (HandsHold Two))
      (or (and (= ?button MicrowaveButton) (Near Robot Microwave)
               (not (state Microwave DoorIsOpen)) (not (state Microwave MicrowaveIsOn)))
          (and (= ?button FridgeButton) (Near Robot Fridge)
               (not (state Fridge LeftDoorIsOpen)) (not (state Fridge WaterDispenserIsOpen)))
          (and (= ?button Tv_1PowerButton) (Near Robot Tv_1) (not (state Tv_1 IsOn)))
          (and (= ?button Tv_1Remote_1PowerButton) (Near Robot Tv_1Remote_1) (not (state Tv_1 IsOn)))))
    :effect (and (increase (total-cost) 2)
      (when (= ?button MicrowaveButton)
        (and (state Microwave MicrowaveIsOn)
             (forall (?x - thing) (when (In ?x Microwave) (state ?x temperatureHigh)))))
      (when (= ?button FridgeButton) (state Fridge WaterDispenserIsOpen))
      (when (or (= ?button Tv_1PowerButton) (= ?button Tv_1Remote_1PowerButton)) (state Tv_1 IsOn))))

  (:action press-off
    :parameters (?button - button)
    :precondition (and
      (not (HandsHold Two))
      (or (and (= ?button MicrowaveButton) (Near Robot Microwave) (state Microwave MicrowaveIsOn))
          (and (= ?button FridgeButton) (Near Robot Fridge) (state Fridge WaterDispenserIsOpen))
          (and (= ?button Tv_1PowerButton) (Near Robot Tv_1) (state Tv_1 IsOn))
          (and (= ?button Tv_1Remote_1PowerButton) (Near Robot Tv_1Remote_1) (state Tv_1 IsOn))))
    :effect (and (increase (total-cost) 2)
      (when (= ?button MicrowaveButton) (not (state Microwave MicrowaveIsOn)))
      (when (= ?button FridgeButton) (not (state Fridge WaterDispenserIsOpen)))
      (when (or (= ?button Tv_1PowerButton) (= ?button Tv_1Remote_1PowerButton)) (not (state Tv_1 IsOn)))))

  ; Channels and volume, on the set or on the remote control, which is pressed where it lies.
  (:action press
    :parameters (?button - button)
    :precondition (and
      (not (HandsHold Two)) (state Tv_1 IsOn)
      (or (and (or (= ?button Tv_1ChannelUpButton) (= ?button Tv_1ChannelDownButton)
                   (= ?button Tv_1VolumeUpButton) (= ?button Tv_1VolumeDownButton))
               (Near Robot Tv_1))
          (and (or (= ?button Tv_1Remote_1ChannelUpButton) (= ?button Tv_1Remote_1ChannelDownButton)
                   (= ?button Tv_1Remote_1VolumeUpButton) (= ?button Tv_1Remote_1VolumeDownButton)
                   (= ?button Tv_1Remote_1MuteButton))
               (Near Robot Tv_1Remote_1))))
    :effect (and (increase (total-cost) 2)
      (when (or (= ?button Tv_1VolumeUpButton) (= ?button Tv_1Remote_1VolumeUpButton)) (state Tv_1 Volume))
      (when (or (= ?button Tv_1VolumeDownButton) (= ?button Tv_1Remote_1VolumeDownButton)
                (= ?button Tv_1Remote_1MuteButton))
        (not (state Tv_1 Volume)))
      (when (or (= ?button Tv_1ChannelUpButton) (= ?button Tv_1Remote_1ChannelUpButton))
        (and (when (state Tv_1 Channel1) (and (not (state Tv_1 Channel1)) (state Tv_1 Channel2)))
             (when (state Tv_1 Channel2) (and (not (state Tv_1 Channel2)) (state Tv_1 Channel3)))
             (when (state Tv_1 Channel3) (and (not (state Tv_1 Channel3)) (state Tv_1 Channel4)))
             (when (state Tv_1 Channel4) (and (not (state Tv_1 Channel4)) (state Tv_1 Channel5)))
             (when (state Tv_1 Channel5) (and (not (state Tv_1 Channel5)) (state Tv_1 Channel6)))
             (when (state Tv_1 Channel6) (and (not (state Tv_1 Channel6)) (state Tv_1 Channel1)))))
      (when (or (= ?button Tv_1ChannelDownButton) (= ?button Tv_1Remote_1ChannelDownButton))
        (and (when (state Tv_1 Channel1) (and (not (state Tv_1 Channel1)) (state Tv_1 Channel6)))
             (when (state Tv_1 Channel2) (and (not (state Tv_1 Channel2)) (state Tv_1 Channel1)))
             (when (state Tv_1 Channel3) (and (not (state Tv_1 Channel3)) (state Tv_1 Channel2)))
             (when (state Tv_1 Channel4) (and (not (state Tv_1 Channel4)) (state Tv_1 Channel3)))
             (when (state Tv_1 Channel5) (and (not (state Tv_1 Channel5)) (state Tv_1 Channel4)))
             (when (state Tv_1 Channel6) (and (not (state Tv_1 Channel6)) (state Tv_1 Channel5)))))))

  ; A microwave stops when its door opens; so does the dispenser in the fridge's left door.
  (:action open
    :parameters (?d - (either container door item))
    :precondition (and
      (or (and (= ?d Microwave) (not (HandsHold Two)) (Near Robot Microwave) (not (state Microwave DoorIsOpen)))
          (and (= ?d FridgeLeftDoor) (not (HandsHold Two)) (Near Robot Fridge) (not (state Fridge LeftDoorIsOpen)))
          (and (= ?d FridgeRightDoor) (not (HandsHold Two)) (Near Robot Fridge) (not (state Fridge RightDoorIsOpen)))
          (and (= ?d BagOfChips_1) (not (HandsHold Two)) (InHand BagOfChips_1))))
    :effect (and (increase (total-cost) 2)
      (when (= ?d Microwave) (and (state Microwave DoorIsOpen) (not (state Microwave MicrowaveIsOn))))
      (when (= ?d FridgeLeftDoor) (and (state Fridge LeftDoorIsOpen) (not (state Fridge WaterDispenserIsOpen))))
      (when (= ?d FridgeRightDoor) (state Fridge RightDoorIsOpen))
      (when (= ?d BagOfChips_1) (state BagOfChips_1 IsOpen))))

  (:action close
    :parameters (?d - (either container door))
    :precondition (and
      (not (HandsHold Two))
      (or (and (= ?d Microwave) (Near Robot Microwave) (state Microwave DoorIsOpen))
          (and (= ?d FridgeLeftDoor) (Near Robot Fridge) (state Fridge LeftDoorIsOpen))
          (and (= ?d FridgeRightDoor) (Near Robot Fridge) (state Fridge RightDoorIsOpen))))
    :effect (and (increase (total-cost) 2)
      (when (= ?d Microwave) (not (state Microwave DoorIsOpen)))
      (when (= ?d FridgeLeftDoor) (not (state Fridge LeftDoorIsOpen)))
      (when (= ?d FridgeRightDoor) (not (state Fridge RightDoorIsOpen)))))

  ; Held under the running dispenser.
  (:action fill
    :parameters (?v - vessel ?from - appliance)
    :precondition (and (= ?from Fridge) (InHand ?v) (Near Robot Fridge) (state Fridge WaterDispenserIsOpen))
    :effect (and (increase (total-cost) 5)
      (state ?v Water) (not (state ?v temperatureHigh))))

  (:action pour
    :parameters (?x - vessel ?y - vessel)
    :precondition (and (InHand ?x) (AtHand ?y) (not (= ?x ?y)))
    :effect (and (increase (total-cost) 2)
      (forall (?c - pourable) (when (state ?x ?c) (and (state ?y ?c) (not (state ?x ?c)))))))

  (:action pour-out
    :parameters (?x - vessel)
    :precondition (InHand ?x)
    :effect (and (increase (total-cost) 2)
      (forall (?c - content) (not (state ?x ?c)))))

  (:action add
    :parameters (?what - (either ingredient scoop) ?x - (either vessel dish))
    :precondition (and
      (AtHand ?x)
      (or (and (or (= ?what Salt_1) (= ?what Ramen_1) (= ?what BoiledEgg_1)) (InHand ?what))
          (and (= ?what IceCreamScoop) (InHand Spoon_1) (state Spoon_1 ScoopsLeft)))
      (imply (= ?what Ramen_1) (not (Unfit Ramen_1 ?x)))
      (imply (= ?what BoiledEgg_1) (not (Unfit BoiledEgg_1 ?x))))
    :effect (and (increase (total-cost) 2)
      (when (= ?what Salt_1) (state ?x Salt))
      (when (= ?what Ramen_1) (and (state ?x Ramen) (In Ramen_1 ?x)))
      (when (= ?what BoiledEgg_1) (and (state ?x Egg) (In BoiledEgg_1 ?x)))
      (when (or (= ?what Ramen_1) (= ?what BoiledEgg_1))
        (and (not (Grasping Robot ?what)) (forall (?h - holder) (not (Held ?what ?h)))
             (when (HandsHold Two) (and (not (HandsHold Two)) (HandsHold One)))
             (when (HandsHold One) (and (not (HandsHold One)) (HandsHold Zero)))))
      (when (= ?what IceCreamScoop) (and (state ?x IceCream) (not (state Spoon_1 ScoopsLeft))))))

  (:action scoop
    :parameters (?spoon - utensil ?source - tub)
    :precondition (and (InHand ?spoon) (AtHand ?source) (state ?source ScoopsLeft))
    :effect (and (increase (total-cost) 2)
      (state ?spoon ScoopsLeft)))

  (:action squeeze
    :parameters (?x - bottle ?y - (either vessel dish tub))
    :precondition (and (InHand ?x) (IsSqueezeable ?x) (AtHand ?y))
    :effect (and (increase (total-cost) 2)
      (forall (?c - pourable) (when (state ?x ?c) (state ?y ?c)))))

  (:action insert
    :parameters (?x - item ?y - appliance)
    :precondition (and (InHand ?x) (state ?x CD) (Near Robot ?y) (= ?y Xbox_1))
    :effect (and (increase (total-cost) 2)
      (state ?y CD) (In ?x ?y) (not (Grasping Robot ?x))
      (forall (?h - holder) (not (Held ?x ?h)))
      (when (HandsHold Two) (and (not (HandsHold Two)) (HandsHold One)))
      (when (HandsHold One) (and (not (HandsHold One)) (HandsHold Zero)))))

  (:action place-utensil
    :parameters (?u - utensil ?y - (either vessel dish))
    :precondition (and (InHand ?u) (AtHand ?y) (not (Unfit ?u ?y)))
    :effect (and (increase (total-cost) 2)
      (In ?u ?y) (not (Grasping Robot ?u))
      (forall (?h - holder) (not (Held ?u ?h)))
      (when (= ?u Fork_1) (state ?y Fork))
      (when (= ?u Spoon_1) (state ?y spoon))
      (when (HandsHold Two) (and (not (HandsHold Two)) (HandsHold One)))
      (when (HandsHold One) (and (not (HandsHold One)) (HandsHold Zero))))))
