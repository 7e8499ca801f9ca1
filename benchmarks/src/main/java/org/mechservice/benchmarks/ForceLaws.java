package org.mechservice.benchmarks;

import java.nio.charset.StandardCharsets;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * Force laws and their derivatives, driven by data: a residual and its Jacobian of a free body and
 * a turning one under {@value #COPIES} forces of one kind. What a law costs is the difference from
 * the kind {@code none}, divided by their number.
 */
@State(Scope.Benchmark)
public class ForceLaws extends Measured {
  private static final int COPIES = 64;

  private static final String PAIR =
      "<body1 name='G' point='o' vector='z' vector2='x'/><body2 name='a' point='p'/>";

  /** The kind of force. */
  @Param({
    "none",
    "spring",
    "rope",
    "bushing",
    "contact",
    "sliding",
    "hill",
    "jointSpring",
    "friction",
    "coupling",
    "stop"
  })
  public String kind = "";

  private LinearisedResidualModel model = MeasuredScenes.linearised(LinkChain.of(1));
  private double[] y = {};
  private double[] yDot = {};
  private double[] values = {};

  /** Reads the model. */
  @Setup
  public void prepare() throws MechmlException {
    model = MeasuredScenes.linearised(mechanism(kind));
    y = new double[model.description().stateCount()];
    yDot = new double[y.length];
    values = new double[y.length];
    model.initialState(y);
    model.linearise(0, y, yDot);
  }

  private static String force(String kind, String name) {
    String element =
        switch (kind) {
          case "none" -> "";
          case "spring" -> "<springDamper name='%s' k='900' c='20' length0='0.7'>" + PAIR;
          case "rope" ->
              "<springDamper name='%s' k='900' c='20' length0='0.3' side='tension'>" + PAIR;
          case "bushing" ->
              "<bushing name='%s' k='900;800;700;90;80;70' c='9;8;7;0.9;0.8;0.7'>" + PAIR;
          case "contact" ->
              "<contact name='%s' radius='1' stiffness='1e4' damping='30' exponent='1.5'>" + PAIR;
          case "sliding" ->
              "<contact name='%s' radius='1' stiffness='1e4' damping='30' friction='0.4'"
                  + " frictionSpeed='0.01'>"
                  + PAIR;
          case "hill" ->
              "<contact name='%s' radius='1' stiffness='1e4' damping='30' height='0.1*sin(s)'>"
                  + PAIR;
          case "jointSpring" ->
              "<torsionSpringDamper name='%s' joint='turn' k='300' c='9' angle0='0.1'/>";
          case "friction" ->
              "<friction name='%s' joint='turn' coulomb='3' speed='0.01' viscous='0.2'/>";
          case "coupling" ->
              "<couplingSpringDamper name='%s' expression='turn.q' k='300' c='9' rest='0.1'/>";
          case "stop" ->
              "<couplingSpringDamper name='%s' expression='turn.q' k='300' c='9' rest='0.1'"
                  + " side='tension'/>";
          default -> throw new IllegalArgumentException(kind);
        };
    String named = element.formatted(name);
    return named.endsWith(PAIR)
        ? named + "</" + named.substring(1, named.indexOf(' ')) + ">"
        : named;
  }

  private static Mechanism mechanism(String kind) throws MechmlException {
    String forces =
        IntStream.range(0, COPIES)
            .mapToObj(i -> force(kind, "f" + i))
            .collect(Collectors.joining());
    String text =
        "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='0.1'/>"
            + "<integrator name='ode15sR' relTol='1e-6' absTol='1e-6'/></dynamic></MBSsimulation>"
            + "<MBSmodel name='laws' massUnits='kg' lengthUnits='m'><Bodies><body name='G'>"
            + "<point name='o' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/>"
            + "<vector name='z' vx='0' vy='0' vz='1'/></body><body name='a'><point name='p'"
            + " x='0.1' y='0.2' z='0.05'/><cog x='0' y='0' z='0'/><mass value='2'/><inertiaTensor"
            + " Ixx='0.1' Iyy='0.2' Izz='0.2' Ixy='0' Ixz='0' Iyz='0'/></body><body name='b'><point"
            + " name='o' x='0' y='0' z='0'/><vector name='x' vx='1' vy='0' vz='0'/><mass value='1'/><inertiaTensor Ixx='0.1' Iyy='0.1' Izz='0.1' Ixy='0' Ixz='0' Iyz='0'/>"
            + "</body></Bodies><Joints><joint name='free' type='F'><body1 name='G' point='o'/><body2"
            + " name='a' point='p'/></joint><joint name='turn' type='R'><body1 name='G' point='o'"
            + " vector='x'/><body2 name='b' point='o' vector='x'/></joint></Joints><Forces>"
            + "<gravity gx='0' gy='0' gz='-9.81'/>"
            + forces
            + "</Forces><topology><root name='G'/><relCoorVals><jointVal name='free'"
            + " posVals='0.8;0.36;0.48;0;0.3;0.2;0.6' velVals='0.1;0.2;-0.3;0.5;0.2;-0.4'/>"
            + "<jointVal name='turn' posVals='0.4' velVals='0.7'/></relCoorVals></topology>"
            + "</MBSmodel></MechML>";
    return MechmlReader.read("laws.xml", text.getBytes(StandardCharsets.UTF_8)).mechanism();
  }

  /** The residual, with the values of the forces. */
  @Benchmark
  public double[] residual() {
    model.residual(0, y, yDot, values);
    return values;
  }

  /** The Jacobian of the residual, with the derivatives of the forces. */
  @Benchmark
  public boolean jacobian() {
    return model.linearise(0, y, yDot);
  }
}
