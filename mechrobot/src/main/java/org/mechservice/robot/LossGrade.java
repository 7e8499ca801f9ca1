package org.mechservice.robot;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.solver.catalogue.MessageCode;

/** How much a part of a robot's file matters that is not in the model. */
public enum LossGrade {
  /** The robot moves otherwise than in the file's own engine. */
  MOTION(MessageCode.ROBOT_LOST, "changes the motion", "change the motion"),
  /** Only contacts, or motors that somebody commands, act otherwise. */
  CONTACT(
      MessageCode.ROBOT_LOST_CONTACT,
      "changes contacts or motors only",
      "change contacts or motors only"),
  /** Only the picture or a note is another. */
  PICTURE(MessageCode.ROBOT_LOST_PICTURE, "is picture or metadata", "are picture or metadata");

  private final MessageCode code;
  private final String one;
  private final String several;

  LossGrade(MessageCode code, String one, String several) {
    this.code = code;
    this.one = one;
    this.several = several;
  }

  /** Returns the code of messages about such losses. */
  public MessageCode code() {
    return code;
  }

  /** Returns {@code 1 changes the motion} or {@code 3 change the motion}. */
  String counted(long count) {
    return count + " " + (count == 1 ? one : several);
  }

  /** Returns the grade of a loss; empty if the message is about something else. */
  public static Optional<LossGrade> of(Diagnostic said) {
    return Arrays.stream(values()).filter(grade -> grade.code == said.code()).findFirst();
  }
}
