package org.mechservice.mechml.document;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Which children an element may have in which order: the content model of a DTD.
 *
 * <p>DTD models are deterministic: the next child's name alone says where in the model it belongs.
 * So a model can be read child by child, each leaving the model of what may still come.
 */
sealed interface ContentModel {
  /** No children. */
  ContentModel EMPTY = new Sequence(List.of());

  /** Returns whether nothing more need come. */
  boolean isComplete();

  /** Returns the names that may come next. */
  Set<String> next();

  /** Returns the names that must still come. */
  Set<String> required();

  /** Returns all names of the model. */
  Set<String> names();

  /**
   * Returns what may come after a child.
   *
   * @param child one of {@link #next()}
   */
  ContentModel after(String child);

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
    public ContentModel after(String child) {
      return EMPTY;
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
    public ContentModel after(String child) {
      return branches.stream()
          .filter(branch -> branch.next().contains(child))
          .findFirst()
          .orElseThrow()
          .after(child);
    }
  }

  /**
   * A part that may be left out or repeated.
   *
   * @param part what is repeated
   * @param optional whether it may be left out
   * @param unbounded whether it may come more than once
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
    public ContentModel after(String child) {
      ContentModel begun = part.after(child);
      ContentModel again = new Repeated(part, true, true);
      return unbounded ? begun.equals(EMPTY) ? again : new Sequence(List.of(begun, again)) : begun;
    }
  }
}
