package org.mechservice.mechml.document;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Content model of a DTD: the children that an element may have, in their order.
 *
 * <p>DTD models are deterministic: the name of the next child determines its position in the model.
 * Each child therefore reduces the model to that of the remaining children.
 */
sealed interface ContentModel {
  /** No children. */
  ContentModel EMPTY = new Sequence(List.of());

  /** Returns whether the remaining children are all optional. */
  boolean isComplete();

  /** Returns the allowed names of the next child. */
  Set<String> next();

  /** Returns the names of the required children that are still missing. */
  Set<String> required();

  /** Returns all names of the model. */
  Set<String> names();

  /**
   * Returns the children as a sentence lists them, each name once, with "either" and "or" between
   * groups that exclude each other.
   *
   * @param told names that are in the list already; those listed here are added
   */
  String listed(Set<String> told);

  /**
   * Returns the model of the children after a child.
   *
   * @param child one of {@link #next()}
   */
  ContentModel after(String child);

  /**
   * Returns the model in which every part may be missing: that of an element under construction.
   */
  ContentModel partial();

  private static String listed(List<ContentModel> models, String separator, Set<String> told) {
    return models.stream()
        .map(model -> model.listed(told))
        .filter(list -> !list.isEmpty())
        .collect(Collectors.joining(separator));
  }

  private static Set<String> namesOf(List<ContentModel> models) {
    Set<String> names = new LinkedHashSet<>();
    models.forEach(model -> names.addAll(model.names()));
    return names;
  }

  /** One child. */
  record Child(String name) implements ContentModel {
    @Override
    public boolean isComplete() {
      return false;
    }

    @Override
    public Set<String> next() {
      return Set.of(name);
    }

    @Override
    public Set<String> required() {
      return Set.of(name);
    }

    @Override
    public Set<String> names() {
      return Set.of(name);
    }

    @Override
    public String listed(Set<String> told) {
      return told.add(name) ? "<" + name + ">" : "";
    }

    @Override
    public ContentModel after(String child) {
      return EMPTY;
    }

    @Override
    public ContentModel partial() {
      return new Repeated(this, true, false);
    }
  }

  /** One part after the other. */
  record Sequence(List<ContentModel> parts) implements ContentModel {
    @Override
    public boolean isComplete() {
      return parts.stream().allMatch(ContentModel::isComplete);
    }

    @Override
    public Set<String> next() {
      Set<String> names = new LinkedHashSet<>();
      for (ContentModel part : parts) {
        names.addAll(part.next());
        if (!part.isComplete()) {
          break;
        }
      }
      return names;
    }

    @Override
    public Set<String> required() {
      Set<String> names = new LinkedHashSet<>();
      parts.forEach(part -> names.addAll(part.required()));
      return names;
    }

    @Override
    public Set<String> names() {
      return namesOf(parts);
    }

    @Override
    public String listed(Set<String> told) {
      return ContentModel.listed(parts, ", ", told);
    }

    @Override
    public ContentModel after(String child) {
      int first = 0;
      while (!parts.get(first).next().contains(child)) {
        first++;
      }
      List<ContentModel> rest = new ArrayList<>();
      ContentModel begun = parts.get(first).after(child);
      if (!begun.equals(EMPTY)) {
        rest.add(begun);
      }
      rest.addAll(parts.subList(first + 1, parts.size()));
      return new Sequence(rest);
    }

    @Override
    public ContentModel partial() {
      return new Sequence(parts.stream().map(ContentModel::partial).toList());
    }
  }

  /** One of several. */
  record Choice(List<ContentModel> branches) implements ContentModel {
    @Override
    public boolean isComplete() {
      return branches.stream().anyMatch(ContentModel::isComplete);
    }

    @Override
    public Set<String> next() {
      Set<String> names = new LinkedHashSet<>();
      branches.forEach(branch -> names.addAll(branch.next()));
      return names;
    }

    @Override
    public Set<String> required() {
      return Set.of();
    }

    @Override
    public Set<String> names() {
      return namesOf(branches);
    }

    @Override
    public String listed(Set<String> told) {
      boolean groups = branches.stream().anyMatch(branch -> branch.names().size() > 1);
      return groups
          ? "either " + ContentModel.listed(branches, " or ", told)
          : ContentModel.listed(branches, ", ", told);
    }

    @Override
    public ContentModel after(String child) {
      return branches.stream()
          .filter(branch -> branch.next().contains(child))
          .findFirst()
          .orElseThrow()
          .after(child);
    }

    @Override
    public ContentModel partial() {
      return new Choice(branches.stream().map(ContentModel::partial).toList());
    }
  }

  /**
   * A part that is optional, repeatable or both.
   *
   * @param part what is repeated
   * @param optional whether it may be omitted
   * @param unbounded whether it may occur more than once
   */
  record Repeated(ContentModel part, boolean optional, boolean unbounded) implements ContentModel {
    @Override
    public boolean isComplete() {
      return optional || part.isComplete();
    }

    @Override
    public Set<String> next() {
      return part.next();
    }

    @Override
    public Set<String> required() {
      return optional ? Set.of() : part.required();
    }

    @Override
    public Set<String> names() {
      return part.names();
    }

    @Override
    public String listed(Set<String> told) {
      return part.listed(told);
    }

    @Override
    public ContentModel after(String child) {
      ContentModel begun = part.after(child);
      ContentModel again = new Repeated(part, true, true);
      return unbounded ? begun.equals(EMPTY) ? again : new Sequence(List.of(begun, again)) : begun;
    }

    @Override
    public ContentModel partial() {
      return new Repeated(part.partial(), true, unbounded);
    }
  }
}
