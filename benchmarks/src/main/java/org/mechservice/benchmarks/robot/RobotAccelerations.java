package org.mechservice.benchmarks.robot;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Timer;
import java.util.TimerTask;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.robot.ImportOptions;
import org.mechservice.robot.LossGrade;
import org.mechservice.robot.RobotImport;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/** Accelerations of imported robots in given states, for comparison with other programs. */
public final class RobotAccelerations {
  private static final int ROWS = 100;

  /** Time between two looks at how long a run takes, ms. */
  private static final int LOOK = 100;

  private RobotAccelerations() {}

  /**
   * Imports robots and computes dv/dt, as the lines of the standard input ask, one after the other.
   *
   * <p>A line has the robot's file; then, behind tabulators, for accelerations a file of states y =
   * [q; v] and the file of dv/dt to write, both as doubles in the order of the machine's network.
   * The answer to a file alone is a line with the counts of positions, velocities and losses that
   * change the motion, and a line for each joint: name, type, first position, first velocity in y.
   * With the word {@code run}, an end of simulated time and a limit of the processor's time, both
   * in s, the robot is imported and run as {@code mech import} and {@code mech simulate} do; the
   * answer has the time reached and the processor's time taken. Each answer ends with an empty
   * line; one that begins with {@code !} says what failed.
   *
   * @param args none
   */
  public static void main(String[] args) throws IOException {
    BufferedReader asked = new BufferedReader(new InputStreamReader(System.in, UTF_8));
    PrintStream answer = new PrintStream(System.out, true, UTF_8);
    String file = "";
    RobotImport robot = null;
    for (String line = asked.readLine(); line != null; line = asked.readLine()) {
      String[] parts = line.split("\t", -1);
      try {
        if (parts.length > 1 && parts[1].equals("run")) {
          run(parts[0], Double.parseDouble(parts[2]), Double.parseDouble(parts[3]), answer);
          answer.println();
          continue;
        }
        if (parts.length == 1 || robot == null || !parts[0].equals(file)) {
          robot = RobotImport.read(Path.of(parts[0]), ImportOptions.NONE);
          file = parts[0];
        }
        if (parts.length == 1) {
          describe(robot, answer);
        } else {
          compute(robot, Path.of(parts[1]), Path.of(parts[2]));
        }
      } catch (IOException | MechmlException | RuntimeException e) {
        robot = null;
        answer.println("! " + String.valueOf(e.getMessage()).lines().findFirst().orElse(""));
      }
      answer.println();
    }
  }

  private static void run(String file, double end, double limit, PrintStream answer)
      throws IOException, MechmlException {
    MechModel model = MechModel.importRobot(Path.of(file)).until(end).every(end / ROWS);
    RunControl control = new RunControl();
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    long thread = Thread.currentThread().getId();
    long begun = threads.getThreadCpuTime(thread);
    Timer watch = new Timer(true);
    watch.schedule(
        new TimerTask() {
          @Override
          public void run() {
            if (threads.getThreadCpuTime(thread) - begun > limit * 1e9) {
              control.stop();
            }
          }
        },
        LOOK,
        LOOK);
    try {
      model.simulate(control);
    } finally {
      watch.cancel();
    }
    answer.printf(
        Locale.ROOT,
        "%g %.2f%n",
        control.time(),
        (threads.getThreadCpuTime(thread) - begun) * 1e-9);
  }

  private static void describe(RobotImport robot, PrintStream answer) {
    Mechanism mechanism = robot.model().mechanism();
    long lost =
        robot.losses().stream().filter(loss -> loss.code() == LossGrade.MOTION.code()).count();
    answer.printf("%d %d %d%n", mechanism.positionCount(), mechanism.velocityCount(), lost);
    for (int i = 0; i < mechanism.joints().size(); i++) {
      Joint joint = mechanism.joints().get(i);
      answer.printf(
          "%s\t%s\t%d\t%d%n",
          joint.name(), joint.type(), mechanism.positionOffset(i), mechanism.velocityOffset(i));
    }
  }

  private static void compute(RobotImport robot, Path states, Path answers) throws IOException {
    Mechanism mechanism = robot.model().mechanism();
    DataDrivenModel model = new DataDrivenModel(mechanism, robot.model().settings().run());
    try (InputStream in = new BufferedInputStream(Files.newInputStream(states));
        OutputStream out = new BufferedOutputStream(Files.newOutputStream(answers))) {
      accelerations(mechanism, model, in, out);
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
