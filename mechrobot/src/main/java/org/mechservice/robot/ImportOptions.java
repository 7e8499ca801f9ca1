package org.mechservice.robot;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What a user asks of an import.
 *
 * @param format format of the file; if empty, its outermost element tells
 * @param keyframe name or number, from 0, of the keyframe of an MJCF file at which the robot starts
 * @param floating whether the root of a robot in URDF moves freely
 * @param paths folders in which packages and models are sought
 * @param looks folder for the files of what bodies look like, relative to the model; empty if
 *     nobody will write them
 */
public record ImportOptions(
    Optional<RobotFormat> format,
    Optional<String> keyframe,
    boolean floating,
    List<Path> paths,
    Optional<String> looks) {
  /** Nothing is asked. */
  public static final ImportOptions NONE =
      new ImportOptions(Optional.empty(), Optional.empty(), false, List.of(), Optional.empty());

  public ImportOptions {
    paths = List.copyOf(paths);
  }
}
