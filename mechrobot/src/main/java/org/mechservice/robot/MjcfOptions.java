package org.mechservice.robot;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.spatial.Vector3;

/**
 * The elements {@code option} of an MJCF model, as far as they decide what acts. Source: MuJoCo
 * documentation, XML reference, {@code option} and {@code flag}.
 *
 * @param gravity acceleration of free fall, m/s²
 * @param springs whether springs of joints and tendons act
 * @param dampers whether their dampers act
 * @param equalities whether equations act
 * @param limits whether ranges of joints and tendons act
 * @param friction whether dry friction acts
 * @param motors whether actuators act
 * @param clamped whether the range of a motor's signal holds
 * @param silent groups of actuators that are off
 * @param density of the medium, kg/m³
 * @param viscosity of the medium, Pa·s
 * @param wind velocity of the medium, m/s
 */
record MjcfOptions(
    Vector3 gravity,
    boolean springs,
    boolean dampers,
    boolean equalities,
    boolean limits,
    boolean friction,
    boolean motors,
    boolean clamped,
    Set<Integer> silent,
    double density,
    double viscosity,
    Vector3 wind) {
  MjcfOptions {
    silent = Set.copyOf(silent);
  }

  /** A world in which everything acts, without gravity and medium. */
  static final MjcfOptions NONE =
      new MjcfOptions(
          Vector3.ZERO, true, true, true, true, true, true, true, Set.of(), 0, 0, Vector3.ZERO);

  static MjcfOptions of(Element mujoco, RobotNumbers numbers) {
    Vector3 gravity = new Vector3(0, 0, -9.81);
    Vector3 wind = Vector3.ZERO;
    double density = 0;
    double viscosity = 0;
    Set<Integer> silent = new HashSet<>();
    for (Element option : mujoco.children("option")) {
      gravity = numbers.vector(option, "gravity", gravity);
      wind = numbers.vector(option, "wind", wind);
      density = numbers.optional(option, "density", density);
      viscosity = numbers.optional(option, "viscosity", viscosity);
      option
          .attribute("actuatorgroupdisable")
          .map(text -> numbers.read(option, "actuatorgroupdisable", text, 0, 31))
          .ifPresent(groups -> groups.forEach(group -> silent.add(group.intValue())));
    }
    boolean passive = isOn(mujoco, "passive");
    boolean constraints = isOn(mujoco, "constraint");
    return new MjcfOptions(
        isOn(mujoco, "gravity") ? gravity : Vector3.ZERO,
        passive && isOn(mujoco, "spring"),
        passive && isOn(mujoco, "damper"),
        constraints && isOn(mujoco, "equality"),
        constraints && isOn(mujoco, "limit"),
        constraints && isOn(mujoco, "frictionloss"),
        isOn(mujoco, "actuation"),
        isOn(mujoco, "clampctrl"),
        silent,
        passive ? density : 0,
        passive ? viscosity : 0,
        wind);
  }

  private static boolean isOn(Element mujoco, String flag) {
    return mujoco.children("option").stream()
        .flatMap(option -> option.children("flag").stream())
        .flatMap(flags -> flags.attribute(flag).stream())
        .reduce((earlier, later) -> later)
        .or(() -> Optional.of("enable"))
        .filter("disable"::equals)
        .isEmpty();
  }
}
