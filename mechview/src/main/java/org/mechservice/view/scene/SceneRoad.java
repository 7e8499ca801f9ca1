package org.mechservice.view.scene;

import java.util.List;
import java.util.function.DoubleUnaryOperator;

/**
 * A surface whose height changes, on which spheres or wheels run.
 *
 * @param name of the first contact or tyre on it
 * @param body index of the body that carries it, or the root's
 * @param frame its axes in those of the body: the height changes along x and is counted along z
 * @param height over x, both in m
 * @param runners centres of the spheres or wheels on it
 * @param radius of the largest, m
 */
public record SceneRoad(
    String name,
    int body,
    BodyPose frame,
    DoubleUnaryOperator height,
    List<Anchor> runners,
    double radius) {
  public SceneRoad {
    runners = List.copyOf(runners);
  }
}
