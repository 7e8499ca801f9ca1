package org.mechservice.view.scene;

/**
 * A belt over two pulleys that turn on one body.
 *
 * @param body the body that both turn on
 * @param at axes in those of the body: from the centre of the first pulley, x to the second, z
 *     along the axles
 * @param first radius of the first pulley, m
 * @param second radius of the second, m
 * @param distance of the axles, m
 */
public record SceneBelt(int body, BodyPose at, double first, double second, double distance) {}
