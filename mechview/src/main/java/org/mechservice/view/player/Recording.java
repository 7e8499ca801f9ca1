package org.mechservice.view.player;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneDescription;

/**
 * The frames of a run. Short runs keep all rows, longer ones at most about 60 per second of
 * simulated time, and no run more than a page may hold: when there are too many, every second frame
 * is dropped. The first and the last row are always kept.
 */
public final class Recording implements ResultSink {
  private static final double INTERVAL = 1.0 / 60;

  /** Numbers kept, of all columns together. */
  private static final int MOST_NUMBERS = 2_000_000;

  private static final int FEWEST_FRAMES = 100;

  /** So many frames are kept however close together they are. */
  private static final int SHORT_RUN = 600;

  private static final String[] POSE = {".x", ".y", ".z", ".e0", ".e1", ".e2", ".e3"};

  private final List<double[]> frames = new ArrayList<>();
  private final Map<String, Integer> places = new HashMap<>();
  private final double closest;
  private List<Variable> columns = List.of();
  private double interval;
  private int mostFrames;
  private double[] last = {};
  private boolean lastKept = true;

  /** Keeps at most about 60 frames a second of a long run. */
  public Recording() {
    this(INTERVAL);
  }

  /**
   * Keeps the frames of a fast motion.
   *
   * @param closest distance of the frames below which a long run is thinned, s
   */
  public Recording(double closest) {
    this.closest = Math.min(INTERVAL, closest);
  }

  /**
   * The body that turns most between two frames.
   *
   * @param body its name
   * @param angle by which it turns, rad
   * @param step from one frame to the next, s
   */
  public record Turn(String body, double angle, double step) {}

  /**
   * Returns the greatest turn between two frames, by the angular velocities at their times; empty
   * if the columns do not tell it.
   */
  public Optional<Turn> greatestTurn(SceneDescription scene) {
    Optional<Turn> greatest = Optional.empty();
    for (SceneBody body : scene.bodies()) {
      OptionalInt w = place(body.name() + ".wx");
      for (int frame = 1; w.isPresent() && frame < frameCount(); frame++) {
        double step = value(frame, 0) - value(frame - 1, 0);
        double angle = Math.min(speed(frame - 1, w.getAsInt()), speed(frame, w.getAsInt())) * step;
        if (angle > greatest.map(Turn::angle).orElse(0.0)) {
          greatest = Optional.of(new Turn(body.name(), angle, step));
        }
      }
    }
    return greatest;
  }

  private double speed(int frame, int column) {
    return Math.hypot(
        value(frame, column), Math.hypot(value(frame, column + 1), value(frame, column + 2)));
  }

  /**
   * Returns the first column that the poses of a scene's bodies need and a result does not have.
   *
   * @param columns those of the result
   */
  public static Optional<String> missing(SceneDescription scene, List<Variable> columns) {
    List<String> names = columns.stream().map(Variable::name).toList();
    return scene.bodies().stream()
        .map(body -> body.name() + POSE[0])
        .filter(name -> !names.contains(name))
        .findFirst();
  }

  @Override
  public void begin(List<Variable> announced) {
    columns = List.copyOf(announced);
    for (Variable column : columns) {
      places.putIfAbsent(column.name(), places.size());
    }
    mostFrames = Math.max(FEWEST_FRAMES, MOST_NUMBERS / columns.size());
  }

  @Override
  public void row(double[] values) {
    last = values.clone();
    // a hair early: the times of rows are sums, which round
    lastKept = frames.isEmpty() || values[0] - lastTime() >= interval * (1 - 1e-9);
    if (lastKept) {
      frames.add(last);
      if (frames.size() > mostFrames || (frames.size() > SHORT_RUN && spacing() < closest)) {
        thin();
      }
    }
  }

  private double lastTime() {
    return frames.get(frames.size() - 1)[0];
  }

  /** Returns the mean distance of the frames, s. */
  private double spacing() {
    return (last[0] - frames.get(0)[0]) / (frames.size() - 1);
  }

  private void thin() {
    interval = 2 * spacing();
    List<double[]> kept = new ArrayList<>();
    for (int i = 0; i < frames.size(); i += 2) {
      kept.add(frames.get(i));
    }
    frames.clear();
    frames.addAll(kept);
    lastKept = lastTime() == last[0];
  }

  private List<double[]> all() {
    if (!lastKept) {
      frames.add(last);
      lastKept = true;
    }
    return frames;
  }

  /** Returns the number of frames. */
  public int frameCount() {
    return all().size();
  }

  /** Returns the columns in their order; the first is time, s. */
  List<Variable> columns() {
    return columns;
  }

  /** Returns the place of a column, if the result has it. */
  OptionalInt place(String name) {
    Integer place = places.get(name);
    return place == null ? OptionalInt.empty() : OptionalInt.of(place);
  }

  /** Returns the time of a frame, s. */
  public double time(int frame) {
    return value(frame, 0);
  }

  /** Returns a number of a frame. */
  double value(int frame, int column) {
    return all().get(frame)[column];
  }

  /** Returns where a body is in a frame; columns that are missing stay at the pose at the start. */
  BodyPose pose(int frame, String body, BodyPose start) {
    OptionalInt x = place(body + POSE[0]);
    if (x.isEmpty()) {
      return start;
    }
    double[] row = all().get(frame);
    int at = x.getAsInt();
    return new BodyPose(
        new Point3(row[at], row[at + 1], row[at + 2]),
        row[at + 3],
        row[at + 4],
        row[at + 5],
        row[at + 6]);
  }
}
