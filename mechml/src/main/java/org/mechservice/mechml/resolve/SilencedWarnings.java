package org.mechservice.mechml.resolve;

import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;

/** Reads which warnings a model silences: attribute {@code silence}, and the reader's options. */
final class SilencedWarnings {
  private SilencedWarnings() {}

  /**
   * Returns the silenced warnings; reports a word that is no warning.
   *
   * @param model the element MBSmodel
   * @param asked names or codes besides those of the file
   */
  static Set<MessageCode> of(Element model, Set<String> asked, Diagnostics diagnostics) {
    Set<String> words = new LinkedHashSet<>();
    model.attribute("silence").ifPresent(list -> words.addAll(List.of(list.split(";", -1))));
    words.addAll(asked);
    Set<MessageCode> silenced = EnumSet.noneOf(MessageCode.class);
    for (String word : words) {
      String name = word.strip();
      Optional<MessageCode> warning = MessageCode.warning(name);
      warning.ifPresent(silenced::add);
      if (warning.isEmpty() && !name.isEmpty()) {
        diagnostics.error(
            MessageCode.VALUE_NOT_IN_LIST, model.position(), Phrase.of("%s", unknown(name)));
      }
    }
    return silenced;
  }

  private static String unknown(String word) {
    if (MessageCode.find(word).isPresent()) {
      return "silence: " + Quoted.of(word) + " is an error; only warnings can be silenced";
    }
    List<String> names =
        List.of(MessageCode.values()).stream()
            .filter(code -> code.severity() == Severity.WARNING)
            .map(MessageCode::word)
            .toList();
    return "silence: there is no warning "
        + Quoted.of(word)
        + "; write the code of one, such as M-090, or its name, such as no-gravity"
        + NearestName.suggestion(word, names);
  }
}
