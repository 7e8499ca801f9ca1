/**
 * Other programs beside the product: evaluations of the same mechanisms by MuJoCo, Pinocchio and
 * generated C.
 *
 * <p>{@link org.mechservice.benchmarks.peer.PeerModels} writes the mechanisms as these programs
 * read them: MJCF by {@link org.mechservice.benchmarks.peer.MujocoText}, and their equations in C
 * by {@link org.mechservice.benchmarks.peer.CText}, with states and expected accelerations. {@code
 * benchmarks/peers/peers.py} runs them, compares the accelerations, and measures.
 *
 * <p>{@link org.mechservice.benchmarks.peer.PeerEvaluations} and {@link
 * org.mechservice.benchmarks.peer.PeerJacobians} are the JMH benchmarks of the product's side:
 * accelerations, and derivatives of the residual, of the same mechanisms in the same states.
 */
@NullMarked
package org.mechservice.benchmarks.peer;

import org.jspecify.annotations.NullMarked;
