package org.mechservice.client;

import java.util.List;
import java.util.Set;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A model of another format, translated by the server.
 *
 * @param text the model in MechML
 * @param messages parts of the file that are not in the model, in file order, then warnings about
 *     the model
 */
public record ImportedModel(String text, List<ModelMessage> messages) {
  private static final Set<String> LOSSES =
      Set.of(
          MessageCode.ROBOT_LOST.code(),
          MessageCode.ROBOT_LOST_CONTACT.code(),
          MessageCode.ROBOT_LOST_PICTURE.code());

  public ImportedModel {
    messages = List.copyOf(messages);
  }

  /** Returns the number of parts of the file that are not in the model. */
  public int lost() {
    return (int) messages.stream().filter(message -> LOSSES.contains(message.code())).count();
  }
}
