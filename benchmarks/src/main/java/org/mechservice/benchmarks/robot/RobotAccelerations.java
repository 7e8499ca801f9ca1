package org.mechservice.benchmarks.robot;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.robot.ImportOptions;
import org.mechservice.robot.LossGrade;
import org.mechservice.robot.RobotImport;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/** Accelerations of imported robots in given states, for comparison with other programs. */
public final class RobotAccelerations {
  private RobotAccelerations() {}

  /**
   * Imports a robot and computes dv/dt.
   *
   * @param args the robot's file; then, for accelerations, a file of states y = [q; v] and the file
   *     of dv/dt to write, both as doubles in the order of the machine's network. Without them the
   *     joints are printed, a line each: name, type, first position, first velocity in y, after a
   *     line with the counts of positions, velocities and losses that change the motion.
   */
  public static void main(String[] args) throws IOException, MechmlException {
    Path file = Path.of(args[0]);
    RobotImport robot = RobotImport.read(file, ImportOptions.NONE);
    Mechanism mechanism = robot.model().mechanism();
    if (args.length == 1) {
      long lost =
          robot.losses().stream().filter(loss -> loss.code() == LossGrade.MOTION.code()).count();
      System.out.printf("%d %d %d%n", mechanism.positionCount(), mechanism.velocityCount(), lost);
      for (int i = 0; i < mechanism.joints().size(); i++) {
        Joint joint = mechanism.joints().get(i);
        System.out.printf(
            "%s\t%s\t%d\t%d%n",
            joint.name(), joint.type(), mechanism.positionOffset(i), mechanism.velocityOffset(i));
      }
      return;
    }
    DataDrivenModel model = new DataDrivenModel(mechanism, robot.model().settings().run());
    try (InputStream states = new BufferedInputStream(Files.newInputStream(Path.of(args[1])));
        OutputStream answers = new BufferedOutputStream(Files.newOutputStream(Path.of(args[2])))) {
      accelerations(mechanism, model, states, answers);
    }
  }

  private static void accelerations(
      Mechanism mechanism, DataDrivenModel model, InputStream states, OutputStream answers)
      throws IOException {
    int positions = mechanism.positionCount();
    int given = positions + mechanism.velocityCount();
    double[] y = new double[mechanism.stateCount()];
    double[] rate = new double[y.length];
    DataInputStream in = new DataInputStream(states);
    DataOutputStream out = new DataOutputStream(answers);
    while (states.available() > 0) {
      for (int i = 0; i < given; i++) {
        y[i] = in.readDouble();
      }
      int status = model.derivative(0, y, rate);
      for (int i = positions; i < given; i++) {
        out.writeDouble(status == ExplicitModel.REGULAR ? rate[i] : Double.NaN);
      }
    }
    out.flush();
  }
}
