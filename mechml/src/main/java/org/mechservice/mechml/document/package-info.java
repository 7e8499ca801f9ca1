/**
 * The XML side of MechML: the bytes of a file become a tree of elements with their positions.
 *
 * <p>{@link org.mechservice.mechml.document.DocumentReader} reads a file with Xerces and checks it
 * against the bundled {@code mechml.dtd}; it opens no other file. {@link
 * org.mechservice.mechml.document.ElementBuilder} builds the tree from the parser's events, {@link
 * org.mechservice.mechml.document.BundledDtd} hands the grammar to the parser, and {@link
 * org.mechservice.mechml.document.Limits} bound the size of a file. {@link
 * org.mechservice.mechml.document.DocumentWriter} writes a tree as canonical text.
 *
 * <p>Xerces decides whether a file is well-formed and valid. Xerces words its errors for XML
 * experts, so two classes reword them: {@link org.mechservice.mechml.document.ParserMessages} those
 * about well-formedness, and {@link org.mechservice.mechml.document.GrammarCheck} those about
 * validity. {@code GrammarCheck} compares the tree with the {@link
 * org.mechservice.mechml.document.Grammar} that {@link
 * org.mechservice.mechml.document.GrammarReader} takes from the same DTD. {@link
 * org.mechservice.mechml.document.Vocabulary} asks the same of elements that a program writes one
 * by one.
 *
 * <p>The package depends on {@code diagnosis} only.
 */
@NullMarked
package org.mechservice.mechml.document;

import org.jspecify.annotations.NullMarked;
