package org.mechservice.library;

import java.util.Optional;

/** Any element of a model under construction, with the attributes and children of the grammar. */
public final class OtherElement extends BuiltElement<OtherElement> {
  OtherElement(String name) {
    super(name, Optional.empty());
  }

  OtherElement(String name, BuiltElement<?> parent) {
    super(name, Optional.of(parent));
  }

  @Override
  OtherElement self() {
    return this;
  }
}
