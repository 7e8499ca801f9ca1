package org.mechservice.view.player;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.view.mesh.Mesh;
import org.mechservice.view.mesh.Solids;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneRoad;

/** A road as far as a motion goes along it, and some way beyond. */
final class RoadStrip {
  /** Most points along a road. */
  private static final int MOST = 600;

  private static final int FEWEST = 200;

  private final SceneDescription scene;
  private final SceneRoad road;
  private final double extent;
  private final double[] least = {Double.MAX_VALUE, Double.MAX_VALUE};
  private final double[] most = {-Double.MAX_VALUE, -Double.MAX_VALUE};

  RoadStrip(SceneDescription scene, SceneRoad road, double extent) {
    this.scene = scene;
    this.road = road;
    this.extent = extent;
  }

  /** Returns the surface in the axes of the road, m. */
  Mesh of(Recording motion) {
    boolean moves = motion.frameCount() > 1;
    for (Anchor runner : road.runners()) {
      reach(place(scene.pose(road.body()), scene.pose(runner.body()), runner));
      for (int frame = 0; moves && frame < motion.frameCount(); frame++) {
        reach(place(pose(motion, frame, road.body()), pose(motion, frame, runner.body()), runner));
      }
    }
    double beyond = moves ? 1.5 * extent : 8 * extent;
    double from = least[0] - beyond;
    double to = most[0] + beyond;
    double fine = Math.max(0.1 * road.radius(), 0.01 * extent);
    int count = (int) Math.max(FEWEST, Math.min(MOST, (to - from) / fine));
    double middle = (least[1] + most[1]) / 2;
    List<double[]> line = new ArrayList<>();
    for (int i = 0; i <= count; i++) {
      double x = from + (to - from) * i / count;
      double height = road.height().applyAsDouble(x);
      if (Double.isFinite(height)) {
        line.add(new double[] {x, height});
      }
    }
    double width = most[1] - least[1] + Math.max(0.3 * extent, 3 * road.radius());
    return Solids.road(line, width, 0.012 * extent)
        .moved(new BodyPose(new Point3(0, middle, 0), 1, 0, 0, 0));
  }

  private BodyPose pose(Recording motion, int frame, int body) {
    return body == Anchor.ROOT
        ? scene.root()
        : motion.pose(frame, scene.bodyName(body), scene.pose(body));
  }

  private Point3 place(BodyPose carrier, BodyPose body, Anchor runner) {
    BodyPose frame = carrier.times(road.frame());
    return frame.turnBack(body.toWorld(runner.point()).minus(frame.position()));
  }

  private void reach(Point3 place) {
    if (Double.isFinite(place.norm())) {
      least[0] = Math.min(least[0], place.x());
      most[0] = Math.max(most[0], place.x());
      least[1] = Math.min(least[1], place.y());
      most[1] = Math.max(most[1], place.y());
    }
  }
}
