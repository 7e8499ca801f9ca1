package org.mechservice.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Rotation;

/** A mechanism that is exported to MJCF is the same when it is imported again. */
class MjcfExportTest {
  private static final double ROUNDING = 1e-12;

  @TempDir private Path folder = Path.of("");

  private static MechmlModel read(String mechml) throws MechmlException {
    return MechmlReader.read("model.xml", mechml.getBytes(StandardCharsets.UTF_8));
  }

  private static RobotImport imported(String mjcf) throws MechmlException {
    return RobotImport.of("model.xml", mjcf.getBytes(StandardCharsets.UTF_8));
  }

  private static RobotExport exported(RobotImport robot) throws MechmlException {
    return RobotExport.mjcf("model.xml", read(DocumentWriter.write(robot.document())));
  }

  private static String resource(String name) throws IOException {
    try (InputStream stream =
        Objects.requireNonNull(MjcfExportTest.class.getResourceAsStream(name), name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static int joint(Mechanism mechanism, String name) {
    List<Joint> joints = mechanism.joints();
    for (int i = 0; i < joints.size(); i++) {
      if (joints.get(i).name().equals(name)) {
        return i;
      }
    }
    throw new AssertionError("no joint " + name);
  }

  /** Compares the accelerations of two models with the same joints in random states. */
  private static void assertMovesAlike(MechmlModel one, MechmlModel other) {
    Mechanism a = one.mechanism();
    Mechanism b = other.mechanism();
    assertThat(b.velocityCount()).isEqualTo(a.velocityCount());
    DataDrivenModel equations = new DataDrivenModel(a, one.settings().run());
    DataDrivenModel again = new DataDrivenModel(b, other.settings().run());
    Random random = new Random(470);
    for (int n = 0; n < 5; n++) {
      double[] ya = new double[a.stateCount()];
      double[] yb = new double[b.stateCount()];
      for (int j = 0; j < a.joints().size(); j++) {
        if (a.joints().get(j).type().velocityCount() == 0) {
          continue;
        }
        int k = joint(b, a.joints().get(j).name());
        int qs = a.joints().get(j).type().positionCount();
        int vs = a.joints().get(j).type().velocityCount();
        double norm = 0;
        for (int i = 0; i < qs; i++) {
          double q = random.nextGaussian();
          ya[a.positionOffset(j) + i] = q;
          norm += i < 4 ? q * q : 0;
        }
        for (int i = 0; i < qs; i++) {
          if (qs > vs && i < 4) {
            ya[a.positionOffset(j) + i] /= Math.sqrt(norm);
          }
          yb[b.positionOffset(k) + i] = ya[a.positionOffset(j) + i];
        }
        for (int i = 0; i < vs; i++) {
          ya[a.positionCount() + a.velocityOffset(j) + i] = random.nextGaussian();
          yb[b.positionCount() + b.velocityOffset(k) + i] =
              ya[a.positionCount() + a.velocityOffset(j) + i];
        }
      }
      for (int s = 0; s < a.furtherStates().size(); s++) {
        double value = random.nextGaussian();
        ya[a.furtherOffset() + s] = value;
        for (int t = 0; t < b.furtherStates().size(); t++) {
          if (b.furtherStates().get(t).name().equals(a.furtherStates().get(s).name())) {
            yb[b.furtherOffset() + t] = value;
          }
        }
      }
      double[] ra = new double[ya.length];
      double[] rb = new double[yb.length];
      equations.derivative(0, ya, ra);
      again.derivative(0, yb, rb);
      double scale = 1;
      for (double r : ra) {
        scale = Math.max(scale, Math.abs(r));
      }
      for (int j = 0; j < a.joints().size(); j++) {
        int vs = a.joints().get(j).type().velocityCount();
        int k = vs == 0 ? 0 : joint(b, a.joints().get(j).name());
        for (int i = 0; i < vs; i++) {
          assertThat(rb[b.positionCount() + b.velocityOffset(k) + i])
              .as(a.joints().get(j).name())
              .isCloseTo(ra[a.positionCount() + a.velocityOffset(j) + i], within(ROUNDING * scale));
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "armature.xml",
        "free.xml",
        "frames.xml",
        "inertia-of-shapes.xml",
        "motor-export.xml",
        "position.xml",
        "position-damping-ratio.xml",
        "replicate.xml",
        "servo-armature.xml",
        "servo-time-constants.xml",
        "springdamper.xml",
        "springdamper-slide.xml",
        "tendon.xml",
        "tendon-auto.xml",
        "tendon-slack.xml",
        "tendon-straight.xml"
      })
  void fileComesBackAsItWas(String name) throws IOException, MechmlException {
    RobotImport first = imported(resource("mjcf/" + name));
    RobotExport export = exported(first);
    assertThat(export.losses()).isEmpty();
    RobotImport second = imported(export.text());
    assertThat(second.losses())
        .extracting(Diagnostic::code)
        .doesNotContain(LossGrade.MOTION.code());
    assertMovesAlike(first.model(), second.model());
  }

  private static final String LOOP =
      "<mujoco><option gravity='0 1 -9'/><worldbody><site name='w' pos='0.5 0 0.1'"
          + " quat='1 2 3 4'/>"
          + "<body name='a' pos='0 0 1'><joint name='j' axis='0 1 0' range='-1 2' stiffness='3'"
          + " springref='20' damping='0.1' armature='0.2'/><geom size='0.1' pos='0.3 0 0'/>"
          + "<body name='b' pos='0.6 0 0'><joint name='k' axis='0 1 0'/><geom size='0.1'"
          + " pos='0.3 0 0'/><site name='s'/></body></body>"
          + "<body name='c' pos='0 1 0'><joint name='x' type='slide' axis='1 1 0'/>"
          + "<geom size='0.1'/></body></worldbody>"
          + "<equality>%s</equality></mujoco>";

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<connect body1='b' anchor='0.4 0 0.1'/>",
        "<weld body1='b' body2='c'/>",
        "<joint joint1='j' joint2='x' polycoef='0.1 2 0 0 0'/>",
        "<joint joint1='j' polycoef='0.1 0 0 0 0'/>"
      })
  void equationsComeBack(String equation) throws MechmlException {
    RobotImport first = imported(LOOP.replace("%s", equation));
    RobotImport second = imported(exported(first).text());
    Mechanism mechanism = second.model().mechanism();
    assertThat(mechanism.closures()).hasSameSizeAs(first.model().mechanism().closures());
    assertThat(mechanism.gravity()).isEqualTo(first.model().mechanism().gravity());
    assertThat(DocumentWriter.write(second.document()))
        .contains("armature=\"0.2\"")
        .contains("lower=\"-0.017453292519943295\"");
    for (int i = 0; i < mechanism.closures().size(); i++) {
      assertSame(
          first.model().mechanism(),
          first.model().mechanism().closures().get(i),
          mechanism,
          mechanism.closures().get(i));
    }
  }

  private static void assertSame(Mechanism a, LoopClosure one, Mechanism b, LoopClosure other) {
    if (one instanceof JointClosure cut) {
      Joint expected = cut.joint();
      Joint again = ((JointClosure) other).joint();
      assertThat(again.type()).isEqualTo(expected.type());
      Attachment at = again.attachment();
      Attachment was = expected.attachment();
      assertThat(body(b, at.parent())).isEqualTo(body(a, was.parent()));
      assertThat(body(b, at.child())).isEqualTo(body(a, was.child()));
      assertThat(at.parentPoint().minus(was.parentPoint()).norm()).isLessThan(ROUNDING);
      assertThat(at.childPoint().minus(was.childPoint()).norm()).isLessThan(ROUNDING);
      Rotation turn = at.zeroRotation().times(was.zeroRotation().transposed());
      assertThat(turn.xx() + turn.yy() + turn.zz()).isCloseTo(3, within(ROUNDING));
    } else {
      assertThat(terms(b, (CoordinateClosure) other)).isEqualTo(terms(a, (CoordinateClosure) one));
    }
  }

  private static String body(Mechanism mechanism, int index) {
    return index == Mechanism.ROOT ? mechanism.root().name() : mechanism.bodies().get(index).name();
  }

  private static Map<String, Double> terms(Mechanism mechanism, CoordinateClosure closure) {
    LinearRelation sum =
        LinearRelation.of(
                closure.relation(),
                mechanism,
                part -> part instanceof Expression.CoordinatePosition)
            .orElseThrow();
    Map<String, Double> terms = new TreeMap<>();
    sum.factors()
        .forEach(
            (of, factor) ->
                terms.put(
                    mechanism.jointOf(((Expression.CoordinatePosition) of).coordinate()).name(),
                    factor));
    terms.put("constant", sum.constant());
    return terms;
  }

  @Test
  void startComesBackAsAKey() throws IOException, MechmlException {
    RobotImport first =
        imported(
            "<mujoco><worldbody><body pos='1 2 3' quat='1 1 0 0'><freejoint name='f'/>"
                + "<geom type='box' size='0.1 0.2 0.3' pos='0.1 0 0'/><body><joint name='j'/>"
                + "<geom size='0.1'/></body></body></worldbody></mujoco>");
    RobotExport export = exported(first);
    assertThat(export.losses()).isEmpty();
    double[] expected = new double[first.model().mechanism().stateCount()];
    first.model().mechanism().initialState(expected);
    Path file = Files.writeString(folder.resolve("export.xml"), export.text());
    boolean keyed = export.text().contains("<keyframe>");
    RobotImport second =
        RobotImport.read(
            file,
            new ImportOptions(
                Optional.empty(),
                keyed ? Optional.of("start") : Optional.empty(),
                false,
                List.of(),
                Optional.empty()));
    double[] y = new double[expected.length];
    second.model().mechanism().initialState(y);
    for (int i = 0; i < y.length; i++) {
      assertThat(y[i]).isCloseTo(expected[i], within(1e-15));
    }
  }

  @Test
  void whatMjcfDoesNotHaveIsRefusedOrLost() throws MechmlException {
    String screw =
        "<MechML><MBSsimulation><dynamic><timeSet tini=\"0\" tend=\"1\" tstep=\"0.1\"/>"
            + "</dynamic></MBSsimulation><MBSmodel name=\"m\" massUnits=\"kg\" lengthUnits=\"m\">"
            + "<Bodies><body name=\"g\"><point name=\"o\" x=\"0\" y=\"0\" z=\"0\"/>"
            + "<vector name=\"z\" vx=\"0\" vy=\"0\" vz=\"1\"/></body>"
            + "<body name=\"b\"><point name=\"o\" x=\"0\" y=\"0\" z=\"0\"/>"
            + "<vector name=\"z\" vx=\"0\" vy=\"0\" vz=\"1\"/><mass value=\"1\"/>"
            + "<inertiaTensor Ixx=\"1\" Iyy=\"1\" Izz=\"1\"/></body></Bodies>"
            + "<Joints><joint name=\"h\" type=\"H\" lead=\"0.1\"><body1 name=\"g\" point=\"o\""
            + " vector=\"z\"/><body2 name=\"b\" point=\"o\" vector=\"z\"/></joint></Joints>"
            + "<Forces><gravity gx=\"0\" gy=\"0\" gz=\"-9.81\"/></Forces>"
            + "<topology><root name=\"g\"/></topology></MBSmodel></MechML>";
    MechmlModel model = read(screw);
    MechmlException refused =
        catchThrowableOfType(MechmlException.class, () -> RobotExport.mjcf("model.xml", model));
    assertThat(refused).hasMessageContaining("M-086").hasMessageContaining("type H");
    RobotExport lost =
        RobotExport.mjcf(
            "model.xml",
            read(
                screw
                    .replace("type=\"H\" lead=\"0.1\"", "type=\"P\"")
                    .replace(
                        "<Forces>",
                        "<Forces><jointForce name=\"push\" joint=\"h\" expression=\"sin(t)\"/>")));
    assertThat(lost.losses()).extracting(one -> one.message()).anyMatch(m -> m.contains("push"));
  }
}
