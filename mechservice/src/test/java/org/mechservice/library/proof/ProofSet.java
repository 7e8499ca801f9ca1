package org.mechservice.library.proof;

import java.util.Optional;
import java.util.stream.LongStream;

/** A set of random scenes, each made from its seed. */
interface ProofSet {
  /** What the scenes are, for the page. */
  String title();

  /** Number of scenes of the full set, seeds from 1. */
  int size();

  /**
   * Returns the scene of a seed; empty if its motion is so sensitive to its start that no reference
   * could decide.
   */
  Optional<Scene> scene(long seed);

  /** Returns the seeds that every build runs: each kind of scene, and quick ones. */
  default LongStream slice() {
    return LongStream.rangeClosed(1, 24);
  }

  /**
   * Returns how many were wrong in silence before steps were searched, of how many, for the page.
   */
  String before();
}
