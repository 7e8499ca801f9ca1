package org.mechservice.robot;

import java.util.Optional;
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
 */
record MjcfOptions(
    Vector3 gravity,
    boolean springs,
    boolean dampers,
    boolean equalities,
    boolean limits,
    boolean friction,
    boolean motors) {
  static MjcfOptions of(Element mujoco, RobotNumbers numbers) {
    Vector3 gravity = new Vector3(0, 0, -9.81);
    for (Element option : mujoco.children("option")) {
      gravity = numbers.vector(option, "gravity", gravity);
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
        isOn(mujoco, "actuation"));
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
