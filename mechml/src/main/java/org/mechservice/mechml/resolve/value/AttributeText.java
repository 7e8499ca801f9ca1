package org.mechservice.mechml.resolve.value;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.mechml.document.Element;

/**
 * A value in an attribute, or one item of a list.
 *
 * @param element the element
 * @param attribute name of the attribute
 * @param text the value's text
 * @param offset of its first character in the attribute, from 0
 */
public record AttributeText(Element element, String attribute, String text, int offset) {

  /** Returns the value of an attribute that the element has. */
  public static AttributeText of(Element element, String attribute) {
    return new AttributeText(element, attribute, element.required(attribute), 0);
  }

  /** Returns the items of a list that the element has. */
  public static List<AttributeText> itemsOf(Element element, String attribute) {
    List<AttributeText> items = new ArrayList<>();
    int offset = 0;
    for (String item : element.required(attribute).split(";", -1)) {
      items.add(new AttributeText(element, attribute, item, offset));
      offset += item.length() + 1;
    }
    return items;
  }
}
