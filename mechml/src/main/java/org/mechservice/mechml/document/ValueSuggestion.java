package org.mechservice.mechml.document;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.mechml.diagnosis.NearestName;

/** Suggests the allowed value of an attribute that a user most likely meant. */
final class ValueSuggestion {
  /** Words of this length or shorter are not compared: they are near to too many others. */
  private static final int SHORT = 3;

  /** Other names of MechML's values, in lower case. */
  private static final Map<String, String> WORDS =
      Map.ofEntries(
              entries("R", "revolute", "rotational", "hinge", "pin", "continuous"),
              entries("P", "prismatic", "slider", "slide", "translational"),
              entries("C", "cylindrical"),
              entries("U", "universal", "cardan", "hooke"),
              entries("S", "spherical", "ball"),
              entries("PL", "planar", "plane"),
              entries("H", "helical", "screw"),
              entries("F", "free", "floating", "6dof"),
              entries("W", "weld", "welded", "fixed", "rigid"),
              entries("m", "meter", "meters", "metre", "metres"),
              entries("cm", "centimeter", "centimetre"),
              entries("mm", "millimeter", "millimetre", "millimeters", "millimetres"),
              entries("in", "inch", "inches"),
              entries("ft", "foot", "feet"),
              entries("kg", "kilogram", "kilograms"),
              entries("g", "gram", "grams"),
              entries("t", "ton", "tonne", "tons"),
              entries("lb", "lbs", "pound", "pounds"),
              entries("rad", "radian", "radians"),
              entries("deg", "degree", "degrees"),
              entries("N", "newton", "newtons"),
              entries("kN", "kilonewton"),
              entries("true", "yes", "on", "1"),
              entries("false", "no", "off", "0"),
              entries("rising", "up"),
              entries("falling", "down"))
          .entrySet()
          .stream()
          .flatMap(e -> e.getValue().stream().map(word -> Map.entry(word, e.getKey())))
          .collect(Collectors.toUnmodifiableMap(Map.Entry::getKey, Map.Entry::getValue));

  private ValueSuggestion() {}

  private static Map.Entry<String, List<String>> entries(String value, String... words) {
    return Map.entry(value, List.of(words));
  }

  /** Returns the allowed value that is probably meant. */
  static Optional<String> meant(String found, List<String> choices) {
    String word = found.strip().toLowerCase(Locale.ROOT);
    return choices.stream()
        .filter(choice -> choice.toLowerCase(Locale.ROOT).equals(word))
        .findFirst()
        .or(() -> Optional.ofNullable(WORDS.get(word)).filter(choices::contains))
        .or(() -> word.length() > SHORT ? NearestName.of(word, choices) : Optional.empty());
  }
}
