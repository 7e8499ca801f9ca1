package org.mechservice.mechml.resolve.value;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The elements of one kind by name. An element that could not be read keeps its name, so that
 * references to it cause no second error.
 *
 * @param <T> type of the values
 */
public final class NameTable<T> {
  /**
   * An element and its value.
   *
   * @param element its element in the file
   * @param value its value; empty if it could not be read
   */
  private record Entry<T>(Element element, Optional<T> value) {}

  private final String kind;
  private final String absence;
  private final Diagnostics diagnostics;
  private final Map<String, Entry<T>> entries = new LinkedHashMap<>();
  private final Set<String> used = new HashSet<>();

  /**
   * Begins empty.
   *
   * @param kind the kind in messages, such as {@code body}
   * @param absence end of the message about an unknown name, such as {@code does not exist}
   * @param diagnostics receives errors and warnings
   */
  public NameTable(String kind, String absence, Diagnostics diagnostics) {
    this.kind = kind;
    this.absence = absence;
    this.diagnostics = diagnostics;
  }

  /** Adds an element with its value; reports a name that is unusable or already taken. */
  public void add(Element element, Optional<T> value) {
    String name = element.required("name");
    NameRule.check(element, diagnostics);
    Entry<T> first = entries.putIfAbsent(name, new Entry<>(element, value));
    if (first != null) {
      diagnostics.error(
          MessageCode.DUPLICATE_NAME,
          element.position(),
          Phrase.of(
              "%s: %s has %s %s with this name",
              element.label(),
              first.element().position().inWords(),
              "aeiou".indexOf(kind.charAt(0)) < 0 ? "a" : "an",
              kind));
    }
  }

  /**
   * Returns the value of a name; reports an unknown name.
   *
   * @param user the element that names it, for the message
   */
  public Optional<T> find(Element user, String name) {
    Entry<T> entry = entries.get(name);
    if (entry != null) {
      used.add(name);
      return entry.value();
    }
    if (!diagnostics.isFull()) {
      diagnostics.error(
          MessageCode.UNKNOWN_NAME,
          user.position(),
          Phrase.of(
              "%s names %s %s, which %s%s",
              user.role(), kind, Quoted.of(name), absence, NearestName.suggestion(name, names())));
    }
    return Optional.empty();
  }

  /** Returns the value of a name; empty without an error if the name is unknown. */
  public Optional<T> value(String name) {
    return Optional.ofNullable(entries.get(name)).flatMap(Entry::value);
  }

  /** Marks a name as used. */
  public void use(String name) {
    used.add(name);
  }

  /** Returns the unused names in file order. */
  public List<String> unused() {
    return entries.keySet().stream().filter(name -> !used.contains(name)).toList();
  }

  /** Returns the names in file order. */
  public Set<String> names() {
    return entries.keySet();
  }
}
