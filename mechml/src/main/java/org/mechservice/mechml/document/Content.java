package org.mechservice.mechml.document;

/** Content of an element: child elements, comments, and the text of another file or language. */
public sealed interface Content permits Element, Comment, Text {}
