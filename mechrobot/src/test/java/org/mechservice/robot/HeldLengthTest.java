package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.mechanism.force.ForceElement;

/**
 * A limit within which an equation holds its joint or tendon does nothing, and is left out: at the
 * very end of a range it would come and go with each rounding, as in public grippers whose tendons
 * are held at 0 in the range from 0 to 1.
 */
class HeldLengthTest {
  private static List<String> forces(String range, String held) throws MechmlException {
    String text =
        """
        <mujoco><compiler angle="radian"/><worldbody>
          <body name="a"><joint name="j" axis="0 1 0"/><geom size="0.1" pos="0.2 0 0"/>
            <body name="b" pos="0 0 0.2"><joint name="k" axis="0 1 0" range="-0.5 0"/>
              <geom size="0.1" pos="0.1 0 0"/></body></body></worldbody>
          <tendon><fixed name="t" range="RANGE"><joint joint="j" coef="1"/>
            <joint joint="k" coef="2"/></fixed></tendon>
          <equality>HELD</equality></mujoco>
        """
            .replace("RANGE", range)
            .replace("HELD", held);
    return RobotImport.of("r.xml", text.getBytes(StandardCharsets.UTF_8))
        .model()
        .mechanism()
        .forces()
        .stream()
        .map(ForceElement::name)
        .toList();
  }

  @ParameterizedTest
  @CsvSource({
    // held at the end of the range, inside and outside of it
    "0 1, <tendon tendon1='t'/>, 0",
    "-1 1, <tendon tendon1='t' polycoef='0.5 0 0 0 0'/>, 0",
    "0.2 1, <tendon tendon1='t'/>, 1",
    "-1 -0.2, <tendon tendon1='t'/>, 1",
    // one that follows another coordinate is not held
    "0 1, '', 2",
  })
  void limitsOfATendonThatIsHeldWithinThemAreLeftOut(String range, String held, int limits)
      throws MechmlException {
    assertThat(forces(range, held)).filteredOn(name -> name.startsWith("t")).hasSize(limits);
  }

  @ParameterizedTest
  @CsvSource({
    "<joint joint1='k'/>, false",
    "<joint joint1='k' polycoef='0.1 0 0 0 0'/>, true",
    "<joint joint1='k' joint2='j'/>, true",
  })
  void limitsOfAJointThatIsHeldWithinThemAreLeftOut(String held, boolean limited)
      throws MechmlException {
    assertThat(forces("-9 9", held).contains("k.upper")).isEqualTo(limited);
  }
}
