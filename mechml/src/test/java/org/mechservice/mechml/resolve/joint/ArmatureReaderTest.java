package org.mechservice.mechml.resolve.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.mechanism.Armature;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/** What armatures add to the coordinates of joints, and where they may be. */
class ArmatureReaderTest {
  private static final Path EXAMPLES = Path.of("../examples");

  private static Mechanism changed(String file, String text, String by)
      throws IOException, MechmlException {
    String whole = Files.readString(EXAMPLES.resolve(file));
    assertThat(whole).contains(text);
    byte[] bytes =
        whole
            .replaceFirst(Pattern.quote(text), Matcher.quoteReplacement(by))
            .getBytes(StandardCharsets.UTF_8);
    return MechmlReader.read(file, bytes).mechanism();
  }

  private static Mechanism joint(String type, String attributes)
      throws IOException, MechmlException {
    String joint = "type=\"" + type + "\"";
    return changed("elements/joint-" + type + ".xml", joint, joint + " " + attributes);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "R | armature='0.3' | 0.3",
        "R | armature='2' armatureUnit='kg*cm^2' gearRatio='10' | 0.02",
        "P | armature='2' gearRatio='3' | 18",
        "C | armature='2; 0.5' gearRatio='1; 10' | 2 50",
        "U | armature='2; 0.5' | 2 0.5",
        "PL | armature='1; 2; 3' | 1 2 3",
        "H | armature='0.1' | 0.1",
        "S | armature='0.1' | 0.1 0.1 0.1",
        "F | armature='0.1; 3' gearRatio='2; 1' | 0.4 0.4 0.4 3 3 3",
      })
  void inertiaIsTheRotorsTimesTheSquareOfTheGear(String type, String attributes, String expected)
      throws IOException, MechmlException {
    List<Armature> armatures = joint(type, attributes.replace('\'', '"')).armatures();
    assertThat(armatures).hasSize(1);
    double[] numbers =
        List.of(expected.split(" ", -1)).stream().mapToDouble(Double::parseDouble).toArray();
    assertThat(armatures.get(0).inertias()).hasSize(numbers.length);
    for (int k = 0; k < numbers.length; k++) {
      assertThat(armatures.get(0).inertias().get(k)).isCloseTo(numbers[k], within(1e-15));
    }
  }

  /** Without armatures the last joint closes the loop; one with an armature stays in the tree. */
  @Test
  void loopIsCutAtAJointWithoutArmature() throws IOException, MechmlException {
    String last = "<joint name=\"D\"";
    assertThat(changed("four-bar/four-bar.xml", last, last).closures())
        .extracting(LoopClosure::name)
        .containsExactly("D");
    Mechanism armed = changed("four-bar/four-bar.xml", last, last + " armature=\"0.1\"");
    assertThat(armed.closures()).extracting(LoopClosure::name).containsExactly("C");
    assertThat(armed.joints().get(armed.armatures().get(0).joint()).name()).isEqualTo("D");
  }

  @Test
  void armatureOfACutJointIsRefused() {
    String last = "<joint name=\"D\"";
    assertThatThrownBy(
            () -> changed("four-bar/four-bar.xml", last, last + " cut=\"true\" armature=\"0.1\""))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining("M-047");
  }
}
