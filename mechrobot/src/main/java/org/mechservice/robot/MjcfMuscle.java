package org.mechservice.robot;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.document.Element;

/**
 * The numbers of a muscle in MJCF, by the names of their attributes, and those that it leaves out.
 *
 * <p>Source: MuJoCo documentation, XML reference, {@code actuator/muscle}, and {@code gainprm} of
 * {@code general}.
 */
final class MjcfMuscle {
  /** The numbers of a muscle in the order of {@code gainprm}, with MuJoCo's values. */
  private static final List<Map.Entry<String, Double>> GAIN =
      List.of(
          Map.entry("low", 0.75),
          Map.entry("high", 1.05),
          Map.entry("force", -1.0),
          Map.entry("scale", 200.0),
          Map.entry("lmin", 0.5),
          Map.entry("lmax", 1.6),
          Map.entry("vmax", 1.5),
          Map.entry("fpmax", 1.3),
          Map.entry("fvmax", 1.2));

  private final RobotNumbers numbers;

  /**
   * @param numbers reports what is no number
   */
  MjcfMuscle(RobotNumbers numbers) {
    this.numbers = numbers;
  }

  /** Returns whether an actuator is a muscle, or a general one that says so in part. */
  static boolean is(Element actuator) {
    return actuator.name().equals("muscle")
        || List.of("gaintype", "biastype", "dyntype").stream()
            .anyMatch(
                kind ->
                    actuator.name().equals("general")
                        && actuator.attribute(kind).filter("muscle"::equals).isPresent());
  }

  /**
   * Returns the numbers of a muscle; empty if it is a general actuator that is no whole one.
   *
   * @param actuator one that {@linkplain #is is} a muscle
   */
  Optional<Map<String, Double>> read(Element actuator) {
    return actuator.name().equals("muscle")
        ? Optional.of(shortcut(actuator))
        : generalMuscle(actuator);
  }

  /**
   * Returns the numbers of a muscle that has attributes of its own. Those that it lacks come from
   * the numbers of a general actuator of its class, where these are not MuJoCo's own.
   */
  private Map<String, Double> shortcut(Element actuator) {
    Map<String, Double> all = ofClass(actuator);
    for (Map.Entry<String, Double> one : GAIN) {
      if (actuator.attribute(one.getKey()).isPresent()) {
        all.put(one.getKey(), numbers.optional(actuator, one.getKey(), one.getValue()));
      }
    }
    actuator
        .attribute("range")
        .map(text -> numbers.read(actuator, "range", text, 2, 2))
        .ifPresent(
            ends -> {
              all.put("low", ends.get(0));
              all.put("high", ends.get(1));
            });
    actuator
        .attribute("timeconst")
        .map(text -> numbers.read(actuator, "timeconst", text, 1, 2))
        .ifPresent(
            times -> {
              all.put("activationTime", times.get(0));
              if (times.size() > 1) {
                all.put("deactivationTime", times.get(1));
              }
            });
    if (actuator.attribute("tausmooth").isPresent()) {
      all.put("blend", numbers.optional(actuator, "tausmooth", 0));
    }
    return all;
  }

  private Map<String, Double> ofClass(Element actuator) {
    List<Double> gain = padded(numbers.several(actuator, "gainprm"), GAIN.size());
    Map<String, Double> all = new LinkedHashMap<>();
    for (int i = 0; i < GAIN.size(); i++) {
      boolean own = gain.get(i) == (i == 0 ? 1 : 0);
      all.put(GAIN.get(i).getKey(), own || gain.get(i) == 0 ? GAIN.get(i).getValue() : gain.get(i));
    }
    List<Double> times = padded(numbers.several(actuator, "dynprm"), 3);
    all.put("activationTime", times.get(0) == 0 || times.get(0) == 1 ? 0.01 : times.get(0));
    all.put("deactivationTime", times.get(1) == 0 ? 0.04 : times.get(1));
    all.put("blend", times.get(2));
    return all;
  }

  /** Returns the numbers of a general actuator that is a muscle; empty if it is no whole one. */
  private Optional<Map<String, Double>> generalMuscle(Element actuator) {
    boolean whole =
        List.of("gaintype", "biastype", "dyntype").stream()
            .allMatch(kind -> actuator.attribute(kind).filter("muscle"::equals).isPresent());
    List<Double> gain = padded(numbers.several(actuator, "gainprm"), GAIN.size());
    List<Double> bias = padded(numbers.several(actuator, "biasprm"), GAIN.size());
    if (!whole || !gain.equals(bias)) {
      return Optional.empty();
    }
    Map<String, Double> all = new LinkedHashMap<>();
    for (int i = 0; i < GAIN.size(); i++) {
      all.put(GAIN.get(i).getKey(), gain.get(i));
    }
    List<Double> times = padded(numbers.several(actuator, "dynprm"), 3);
    all.put("activationTime", times.get(0));
    all.put("deactivationTime", times.get(1));
    all.put("blend", times.get(2));
    return Optional.of(all);
  }

  private static List<Double> padded(List<Double> given, int count) {
    List<Double> all = new ArrayList<>(given);
    while (all.size() < count) {
      all.add(0.0);
    }
    return List.copyOf(all.subList(0, count));
  }
}
