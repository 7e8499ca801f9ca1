package org.mechservice.spark;

import java.io.Serializable;

/**
 * Successive points of a study.
 *
 * @param first from 0
 * @param end the point after the last
 */
record Chunk(int first, int end) implements Serializable {
  int size() {
    return end - first;
  }
}
