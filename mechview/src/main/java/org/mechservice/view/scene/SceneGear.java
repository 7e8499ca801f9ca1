package org.mechservice.view.scene;

/**
 * A gear wheel that a coupling of joints stands for.
 *
 * @param body the body that it is a part of
 * @param centre in body axes, m
 * @param axis unit vector in body axes
 * @param radius of the pitch circle, m
 * @param ring whether its teeth are inside
 */
public record SceneGear(int body, Point3 centre, Point3 axis, double radius, boolean ring) {}
