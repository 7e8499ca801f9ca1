/**
 * A model file as a tree of elements that know their place, read with Xerces and checked against
 * the bundled {@code mechml.dtd}.
 *
 * <p>Xerces decides whether a file is well-formed and valid. Where it is not valid, {@link
 * org.mechservice.mechml.document.GrammarCheck} says why in words of our own, from the same DTD.
 */
@NullMarked
package org.mechservice.mechml.document;

import org.jspecify.annotations.NullMarked;
