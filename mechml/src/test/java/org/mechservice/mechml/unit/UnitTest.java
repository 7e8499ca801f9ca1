package org.mechservice.mechml.unit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class UnitTest {
  /** One rounding in the factor, one in the product. */
  private static final double ROUNDING = 3e-16;

  @ParameterizedTest
  @CsvSource({
    "kg, 1",
    "g, 0.001",
    "t, 1000",
    "lb, 0.45359237",
    "slug, 14.593902937206364",
    "m, 1",
    "cm, 0.01",
    "mm, 0.001",
    "in, 0.0254",
    "ft, 0.3048",
    "rad, 1",
    "deg, 0.017453292519943295",
    "s, 1",
    "ms, 0.001",
    "min, 60",
    "h, 3600",
    "N, 1",
    "kN, 1000",
    "lbf, 4.4482216152605",
    "kg*m^2, 1",
    "g*mm^2, 1e-9",
    "g*mm², 1e-9",
    "kg·cm^2, 1e-4",
    "m/s^2, 1",
    "mm/s/s, 0.001",
    "mm*s^-2, 0.001",
    "1/s, 1",
    "' N * m ', 1"
  })
  void oneOfAUnitIsThisMuchInSi(String text, double expected) throws UnitException {
    assertThat(UnitParser.parse(text).toSi(1)).isCloseTo(expected, within(expected * ROUNDING));
  }

  @ParameterizedTest
  @CsvSource({
    "N, kg*m/s^2",
    "kN, t*m/s^2",
    "lbf, slug*ft/s^2",
    "mm, ft",
    "deg, rad",
    "kg*m^2, N*m*s^2",
    "1, m/m"
  })
  void unitsOfOneDimensionCompare(String one, String other) throws UnitException {
    assertThat(UnitParser.parse(one).dimension()).isEqualTo(UnitParser.parse(other).dimension());
  }

  @Test
  void lbfIsWhatAccelerates1SlugBy1Foot() throws UnitException {
    double derived = UnitParser.parse("slug*ft/s^2").toSi(1);
    assertThat(derived).isCloseTo(UnitParser.parse("lbf").toSi(1), within(2e-15));
  }

  @ParameterizedTest
  @CsvSource({"m, kg", "rad, 1", "rad, m", "m/s, m/s^2"})
  void differentDimensionsDiffer(String one, String other) throws UnitException {
    assertThat(UnitParser.parse(one).dimension()).isNotEqualTo(UnitParser.parse(other).dimension());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "''      | \"\" is not a unit; write symbols joined by * and /, as in kg*m^2",
        "/s      | \"/s\" is not a unit; write symbols joined by * and /, as in kg*m^2",
        "kg m    | \"kg m\" is not a unit; write symbols joined by * and /, as in kg*m^2",
        "m^99    | \"m^99\" is not a unit; write symbols joined by * and /, as in kg*m^2",
        "Kg      | \"Kg\" is not a unit; did you mean \"kg\"?",
        "furlong | \"furlong\" is not a unit; known are kg, g, t, lb, slug, m, cm, mm, in, ft, rad, deg, s, ms, min, h, N, kN, lbf"
      })
  void whatIsNoUnitSaysWhy(String text, String message) {
    assertThatThrownBy(() -> UnitParser.parse(text))
        .isInstanceOf(UnitException.class)
        .hasMessage(message);
  }

  @Test
  void dimensionsHaveNamesWherePeopleHaveOne() throws UnitException {
    assertThat(UnitParser.parse("ft/s^2").dimension()).hasToString("an acceleration");
    assertThat(UnitParser.parse("m/s^3").dimension()).hasToString("length*time^-3");
  }
}
