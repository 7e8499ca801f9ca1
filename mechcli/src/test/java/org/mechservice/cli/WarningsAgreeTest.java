package org.mechservice.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.library.MechModel;

/**
 * Of one model the check, a run at a server, one on this machine, strict ones and the library say
 * the same before it runs, and refuse it alike.
 */
@Tag("slow")
class WarningsAgreeTest {
  /** A warning with its place in the file, as all of them print it. */
  private static final Pattern WARNING = Pattern.compile("\\.xml:\\d+(:\\d+)?: ([MNS]-\\d{3}) ");

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();
  private final Path folder;

  WarningsAgreeTest(@TempDir Path folder) {
    this.folder = folder;
  }

  private int mech(String... words) {
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  /** Returns the codes of all warnings printed. */
  private Set<String> said() {
    return codes(out.toString() + err);
  }

  private static Set<String> codes(String text) {
    Set<String> codes = new TreeSet<>();
    Matcher matcher = WARNING.matcher(text);
    while (matcher.find()) {
      codes.add(matcher.group(2));
    }
    return codes;
  }

  /**
   * A scene of a body m on a joint s, another body n on r, and what stands between.
   *
   * @param m elements of the body m
   */
  private Path scene(String joint, String m, String constraints, String forces) throws IOException {
    String text =
        "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.2' tstep='0.1'/></dynamic>"
            + "</MBSsimulation><MBSmodel name='scene' massUnits='kg' lengthUnits='m'><Bodies>"
            + "<body name='ground'/><body name='m'>"
            + m
            + "</body><body name='n'><mass value='1'/></body></Bodies><Joints><joint name='s'"
            + " type='"
            + joint
            + "' body1='ground' body2='m' axis='0;0;1'/><joint name='r' type='P' body1='ground'"
            + " body2='n' axis='0;0;1'/></Joints><Constraints>"
            + constraints
            + "</Constraints><Forces>"
            + forces
            + "</Forces><topology><root name='ground'/><relCoorVals><jointVal name='r'"
            + " velVals='1'/></relCoorVals></topology></MBSmodel></MechML>";
    Path file = folder.resolve("scene.xml");
    return Files.writeString(file, text.replace("<Constraints></Constraints>", ""));
  }

  private static final String MASS = "<mass value='1'/>";
  private static final String NO_GRAVITY = "<gravity gx='0' gy='0' gz='0'/>";

  private Path model(String name) throws IOException {
    String later = "expression='s.q - 0.1*smoothStep(t-0.1)'";
    return switch (name) {
      case "nothing wrong" ->
          scene("P", MASS, "", NO_GRAVITY + "<jointForce name='f' joint='s' expression='1'/>");
      case "at rest" -> scene("P", MASS, "", NO_GRAVITY);
      case "coupling over time" ->
          scene(
              "P", MASS, "", NO_GRAVITY + "<couplingSpringDamper name='k' k='100' " + later + "/>");
      case "constraint over time" ->
          scene("P", MASS, "<CoordConstraint name='c' " + later + "/>", NO_GRAVITY);
      case "mass on its axis" ->
          scene("R", MASS, "", NO_GRAVITY + "<jointForce name='f' joint='s' expression='1'/>");
      case "no mass" ->
          scene("P", "", "", NO_GRAVITY + "<jointForce name='f' joint='s' expression='1'/>");
      case "spring in one body" ->
          scene(
              "P",
              "<point name='o' x='0' y='0' z='0'/><point name='e' x='1' y='0' z='0'/>" + MASS,
              "",
              "<gravity gx='0' gy='0' gz='-1'/><springDamper name='k' k='1' length0='1'><body1"
                  + " name='m' point='o'/><body2 name='m' point='e'/></springDamper>");
      case "no word of gravity" ->
          scene("P", MASS, "", "<jointForce name='f' joint='s' expression='1'/>");
      case "pulse" ->
          scene(
              "P",
              MASS,
              "",
              NO_GRAVITY + "<jointForce name='f' joint='s' expression='exp(-((t-0.1)/1e-4)^2)'/>");
      case "friction that jumps" ->
          scene(
              "P",
              MASS,
              "",
              NO_GRAVITY + "<jointForce name='f' joint='s' expression='1-signum(s.v)'/>");
      default -> Path.of("../examples/" + name + ".xml");
    };
  }

  @ParameterizedTest
  @CsvSource({
    "nothing wrong, ''",
    "pulse, ''",
    "at rest, N-036",
    "coupling over time, ''",
    "constraint over time, ''",
    "mass on its axis, S-086",
    "no mass, S-086",
    "spring in one body, M-095",
    "no word of gravity, M-090",
    "friction that jumps, N-028",
    "extremes/fourbar_redundant, S-090",
    "extremes/coaxial_massless, N-002"
  })
  void modelIsJudgedAlikeByAll(String name, String code) throws Exception {
    String file = model(name).toString();
    String csv = folder.resolve("r.csv").toString();
    Set<String> expected = code.isEmpty() ? Set.of() : Set.of(code);
    int refused = expected.isEmpty() ? 0 : 2;

    assertThat(mech("check", file)).isZero();
    assertThat(said()).as("check").isEqualTo(expected);
    for (String mode : new String[] {"remote", "local"}) {
      mech("simulate", file, "--mode", mode, "--out", csv);
      assertThat(said()).as("simulate " + mode).isEqualTo(expected);
      int status = mech("simulate", file, "--mode", mode, "--strict", "--out", csv);
      assertThat(status).as("simulate %s --strict: %s", mode, err).isEqualTo(refused);
      assertThat(said()).as("simulate --strict " + mode).isEqualTo(expected);
    }
    assertThat(mech("check", file, "--strict")).as("check --strict").isEqualTo(refused);

    MechModel model = MechModel.read(Path.of(file));
    assertThat(codes(String.join("\n", model.check().warnings()))).isEqualTo(expected);
    if (refused == 0) {
      assertThat(catchThrowable(() -> model.strict().simulate())).isNull();
    } else {
      assertThatIllegalArgumentException()
          .isThrownBy(() -> model.strict().simulate())
          .withMessageContaining("S-164")
          .withMessageContaining(code);
    }
  }
}
