package org.mechservice.mechml.resolve.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.Look;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.Solid;
import org.mechservice.mechml.resolve.MechmlReader;

/** What a body looks like has no part in its mass. */
class LookReaderTest {
  private static MechmlModel read(String looks) throws Exception {
    String model =
        """
        <MechML>
          <MBSsimulation><dynamic><timeSet tini="0" tend="1" tstep="0.1"/></dynamic></MBSsimulation>
          <MBSmodel name="m" massUnits="kg" lengthUnits="m" silence="no-gravity">
            <Bodies>
              <body name="ground"/>
              <body name="bar">
                <point name="tip" x="1" y="0" z="0"/>
                <mass value="2"/><inertiaTensor Ixx="1" Iyy="1" Izz="1"/>
                LOOKS
              </body>
            </Bodies>
            <Joints>
              <joint name="j" type="R" body1="ground" body2="bar" at="0;0;0" axis="0;1;0"/>
            </Joints>
            <topology><root name="ground"/></topology>
          </MBSmodel>
        </MechML>
        """;
    byte[] text = model.replace("LOOKS", looks).getBytes(StandardCharsets.UTF_8);
    return MechmlReader.read("m.xml", text, ReadOptions.NONE);
  }

  @Test
  void bodyWithMassByNumbersHasLooks() throws Exception {
    MechmlModel model =
        read(
            "<look colour='#c04020'><capsule radius='0.1' from='0;0;0' to='tip'/></look>"
                + "<look point='tip' axis='0;2;0' angle='90' angleUnit='deg' opacity='0.5'>"
                + "<sphere radius='0.2'/><surface file='a.obj' lengthUnit='mm'/></look>");

    assertThat(model.mechanism().bodies().get(0).mass()).isEqualTo(2);
    List<Look> looks = model.looks("bar");
    assertThat(looks).hasSize(2);
    assertThat(looks.get(0).colour()).hasValue(0xc04020);
    assertThat(looks.get(0).solids()).hasSize(3).hasAtLeastOneElementOfType(Solid.Round.class);
    assertThat(looks.get(1).origin().x()).isEqualTo(1);
    assertThat(looks.get(1).axis().y()).isEqualTo(1);
    assertThat(looks.get(1).angle()).isCloseTo(Math.PI / 2, within(1e-12));
    assertThat(looks.get(1).opacity()).isEqualTo(0.5);
    assertThat(looks.get(1).solids().get(1))
        .isInstanceOfSatisfying(
            Solid.Surface.class, one -> assertThat(one.scale()).isEqualTo(0.001));
  }

  @CsvSource(
      delimiter = '|',
      value = {
        "<look colour='red'><sphere radius='1'/></look> | colour is #rrggbb",
        "<look opacity='0'><sphere radius='1'/></look> | opacity is more than 0 and at most 1",
        "<look axis='0;0;0'><sphere radius='1'/></look> | axis has no direction",
        "<look><sphere radius='1' density='1'/></look> | a look has no mass",
        "<look><capsule radius='1' from='tip' to='tip'/></look> | lie in one place",
        "<look><sphere radius='-1'/></look> | it must be positive",
      })
  @ParameterizedTest
  void wrongValueIsRefusedByName(String look, String why) {
    assertThatThrownBy(() -> read(look)).hasMessageContaining(why).hasMessageContaining("m.xml:");
  }
}
