package org.mechservice.solver.force.user;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration.Reads;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.force.applied.NoJacobian;
import org.mechservice.solver.force.applied.OuterProduct;
import org.mechservice.solver.force.applied.TreeCoordinate;
import org.mechservice.solver.force.formula.LeafInput;
import org.mechservice.solver.force.formula.PointInput;
import org.mechservice.solver.force.formula.TurnInput;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.text.WellFormedText;

/**
 * A user force applied to a motion. Its derivatives are its own, or central differences over the
 * declared quantities; both are transformed from readings to links and joints in the same way.
 */
public final class AppliedUserForce extends AppliedForce implements ForceBlocks {
  /** Largest length of a message from a class, in characters; the rest is cut off. */
  private static final int MOST_TEXT = 2000;

  private final UserForce law;
  private final TreeMotion motion;
  private final List<Variable> variables;
  private final DeclaredPoint[] points;
  private final TreeCoordinate[] coordinates;
  private final UserForceReading reading;
  private final List<UserForceSensor> sensors = new ArrayList<>();

  /** Index of the first of three sensors for each quantity read of each point. */
  private final List<Map<Reads, Integer>> pointSensor = new ArrayList<>();

  /** Sensor of each coordinate's position, −1 if it has none; sensor of its rate. */
  private final int[] positionSensor;

  private final int[] rateSensor;

  /** Derivative of all loads by one reading: 6 per point, then 1 per coordinate. */
  private final double[] change;

  private final double[] forceTorque = new double[6];
  private final double[] wrench = new double[6];
  private final double[] byPlace = new double[36];
  private final double[] nothing = new double[36];
  private final OuterProduct product = new OuterProduct(NoJacobian.INSTANCE);

  public AppliedUserForce(UserForceElement element, TreeMotion motion, UserForceSource source) {
    super(element);
    this.motion = motion;
    law = source.create(element);
    UserForceNames names = new UserForceNames(element, motion.tree());
    declare(element, names);
    variables = List.copyOf(names.values);
    points = names.points.toArray(DeclaredPoint[]::new);
    coordinates = names.coordinates.toArray(TreeCoordinate[]::new);
    reading = new UserForceReading(names, motion.tree().mechanism().parameters().size());
    positionSensor = new int[coordinates.length];
    rateSensor = new int[coordinates.length];
    change = new double[6 * points.length + coordinates.length];
    for (int p = 0; p < points.length; p++) {
      pointSensor.add(new EnumMap<>(Reads.class));
      addSensors(p, names);
    }
    for (int c = 0; c < coordinates.length; c++) {
      addSensors(c);
    }
  }

  private void declare(UserForceElement element, UserForceNames names) {
    try {
      law.declare(names);
    } catch (OutOfMemoryError memory) {
      throw memory; // of the process, not of the class
    } catch (Throwable e) {
      String said = String.valueOf(e.getMessage());
      throw new IllegalArgumentException(
          said.startsWith(UserForceNames.REFUSED)
              ? said
              : UserForceNames.REFUSED
                  + element.name()
                  + "\" cannot be declared: its class threw "
                  + described(e),
          e);
    }
  }

  private void addSensors(int p, UserForceNames names) {
    DeclaredPoint point = points[p];
    for (Reads reads : Reads.values()) {
      if (point.link == TreeGeometry.ROOT || !point.reads.contains(reads)) {
        continue;
      }
      pointSensor.get(p).put(reads, sensors.size());
      for (int axis = 0; axis < 3; axis++) {
        sensors.add(
            switch (reads) {
              case POSITION ->
                  new UserForceSensor(
                      new PointInput(motion, names.bodyPoints.get(p), axis, false),
                      point.position,
                      axis);
              case VELOCITY ->
                  new UserForceSensor(
                      new PointInput(motion, names.bodyPoints.get(p), axis, true),
                      point.velocity,
                      axis);
              case ROTATION ->
                  UserForceSensor.rotation(
                      new TurnInput(motion, point.link, axis, false), point.rotation, axis);
              case ANGULAR_VELOCITY ->
                  new UserForceSensor(
                      new TurnInput(motion, point.link, axis, true), point.angularVelocity, axis);
            });
      }
    }
  }

  private void addSensors(int c) {
    boolean hasPosition = coordinates[c].position() >= 0;
    positionSensor[c] = hasPosition ? sensors.size() : -1;
    if (hasPosition) {
      LeafInput input = LeafInput.ofCoordinate(motion, coordinates[c], false);
      sensors.add(new UserForceSensor(input, reading.position, c));
    }
    rateSensor[c] = sensors.size();
    LeafInput input = LeafInput.ofCoordinate(motion, coordinates[c], true);
    sensors.add(new UserForceSensor(input, reading.rate, c));
  }

  @Override
  public List<Variable> variables(Mechanism mechanism) {
    return variables;
  }

  @Override
  public boolean parameters(double[] values) {
    reading.parameters(values);
    return true;
  }

  @Override
  public boolean apply(double t, double[] wrenches, double[] tau) {
    reading.read(t, motion);
    if (!evaluate()) {
      return false;
    }
    for (DeclaredPoint point : points) {
      if (point.link != TreeGeometry.ROOT) {
        point.toWrench(motion, point.load, wrench);
        for (int i = 0; i < 6; i++) {
          wrenches[6 * point.link + i] += wrench[i];
        }
      }
    }
    for (int c = 0; c < coordinates.length; c++) {
      tau[coordinates[c].velocity()] += reading.jointForce[c];
    }
    return true;
  }

  /** Calls the user's class with the present readings. */
  private boolean evaluate() {
    reading.clear();
    try {
      law.apply(reading, reading);
    } catch (OutOfMemoryError memory) {
      throw memory; // of the process, not of the class
    } catch (Throwable failure) {
      return thrown(failure);
    }
    for (DeclaredPoint point : points) {
      for (int i = 0; i < 6; i++) {
        if (!Double.isFinite(point.load[i])) {
          return notFinite(i < 3 ? "force" : "torque", point.load[i]);
        }
      }
    }
    for (double force : reading.jointForce) {
      if (!Double.isFinite(force)) {
        return notFinite("joint force", force);
      }
    }
    return true;
  }

  /**
   * Returns class and message of an exception of the user's class; getting the message runs code of
   * that class.
   */
  /** Returns what was thrown in one line, without characters that would steer a terminal. */
  private static String described(Throwable thrown) {
    try {
      String text = thrown.toString();
      String shown = text.length() > MOST_TEXT ? text.substring(0, MOST_TEXT) + "..." : text;
      return WellFormedText.of(shown.replaceAll("\\p{Cntrl}", "?"));
    } catch (RuntimeException | Error e) {
      return thrown.getClass().getName();
    }
  }

  private boolean thrown(Throwable failure) {
    return fail(
        MessageCode.USER_FORCE_FAILED,
        "Its class threw " + described(failure) + ".",
        "Correct the class; at a state that it cannot handle it may return forces that are not"
            + " finite.");
  }

  @Override
  public boolean linearise(double t, ForceJacobian sink) {
    product.to(sink);
    boolean given = law instanceof UserForce.Derivatives;
    if (given ? !differentiate() : !takeDifferences()) {
      return false;
    }
    for (DeclaredPoint point : points) {
      if (point.link != TreeGeometry.ROOT) {
        Arrays.fill(byPlace, 0);
        point.turnAgainstLink(motion, byPlace);
        sink.wrenchByLink(point.link, point.link, byPlace, nothing);
      }
    }
    return true;
  }

  private boolean differentiate() {
    try {
      ((UserForce.Derivatives) law).differentiate(reading, this);
    } catch (OutOfMemoryError memory) {
      throw memory; // of the process, not of the class
    } catch (Throwable failure) {
      return thrown(failure);
    }
    return true;
  }

  /** Takes central differences over the readings; restores all values. */
  private boolean takeDifferences() {
    double t = reading.time();
    for (int i = 0; i < sensors.size(); i++) {
      UserForceSensor sensor = sensors.get(i);
      double h = sensor.step();
      sensor.shift(h);
      if (!evaluate()) {
        return false;
      }
      addLoads(0.5 / h, true);
      sensor.shift(-2 * h);
      if (!evaluate()) {
        return false;
      }
      addLoads(-0.5 / h, false);
      reading.read(t, motion);
      emit(sensor);
    }
    return evaluate();
  }

  private void addLoads(double factor, boolean afresh) {
    if (afresh) {
      Arrays.fill(change, 0);
    }
    for (int p = 0; p < points.length; p++) {
      for (int i = 0; i < 6; i++) {
        change[6 * p + i] += factor * points[p].load[i];
      }
    }
    for (int c = 0; c < coordinates.length; c++) {
      change[6 * points.length + c] += factor * reading.jointForce[c];
    }
  }

  /**
   * Passes the derivative of all loads by one reading on to the links and coordinates of the
   * reading.
   */
  private void emit(UserForceSensor sensor) {
    for (int p = 0; p < points.length; p++) {
      boolean any = false;
      for (int i = 0; i < 6; i++) {
        forceTorque[i] = change[6 * p + i];
        any |= forceTorque[i] != 0;
      }
      if (any && points[p].link != TreeGeometry.ROOT) {
        points[p].toWrench(motion, forceTorque, wrench);
        product.wrench(points[p].link, wrench, 1);
        sensor.input.gradient(product);
      }
    }
    for (int c = 0; c < coordinates.length; c++) {
      double slope = change[6 * points.length + c];
      if (slope != 0) {
        product.force(coordinates[c].velocity(), slope);
        sensor.input.gradient(product);
      }
    }
  }

  @Override
  public void byPoint(Load load, int on, Reads by, int point, double[] block) {
    Integer first = pointSensor.get(point).get(by);
    if (first == null) {
      if (points[point].link == TreeGeometry.ROOT) {
        return;
      }
      throw new IllegalStateException(
          "point " + point + " was not declared to be read for its " + by);
    }
    for (int axis = 0; axis < 3; axis++) {
      putColumn(load, on, block, axis, load == Load.JOINT_FORCE ? 1 : 3);
      emit(sensors.get(first + axis));
    }
  }

  @Override
  public void byCoordinate(
      Load load, int on, int coordinate, double[] byPosition, double[] byRate) {
    if (positionSensor[coordinate] >= 0) {
      putColumn(load, on, byPosition, 0, 1);
      emit(sensors.get(positionSensor[coordinate]));
    }
    putColumn(load, on, byRate, 0, 1);
    emit(sensors.get(rateSensor[coordinate]));
  }

  /** Copies one column of a block to {@link #change}; {@code stride} is the distance of rows. */
  private void putColumn(Load load, int on, double[] block, int column, int stride) {
    Arrays.fill(change, 0);
    switch (load) {
      case FORCE, TORQUE -> {
        int at = 6 * on + (load == Load.FORCE ? 0 : 3);
        for (int i = 0; i < 3; i++) {
          change[at + i] = block[stride * i + column];
        }
      }
      case JOINT_FORCE -> change[6 * points.length + on] = block[column];
    }
  }

  @Override
  public double potentialEnergy() {
    return 0;
  }

  @Override
  public double power() {
    double sum = 0;
    for (DeclaredPoint point : points) {
      sum += point.power();
    }
    for (int c = 0; c < coordinates.length; c++) {
      sum += reading.jointForce[c] * reading.rate[c];
    }
    return sum;
  }

  @Override
  public void values(double[] out, int at) {
    System.arraycopy(reading.values, 0, out, at, reading.values.length);
  }

  @Override
  public void couplings(Couplings couplings) {
    for (DeclaredPoint on : points) {
      if (on.link != TreeGeometry.ROOT) {
        sensors.forEach(sensor -> sensor.input.links(by -> couplings.couple(on.link, by)));
      }
    }
    for (TreeCoordinate coordinate : coordinates) {
      int on = motion.tree().linkOfVelocity[coordinate.velocity()];
      sensors.forEach(sensor -> sensor.input.links(by -> couplings.couple(on, by)));
    }
  }
}
