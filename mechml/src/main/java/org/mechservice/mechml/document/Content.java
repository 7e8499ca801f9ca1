package org.mechservice.mechml.document;

/** Content of an element: child elements, comments and, in files of other languages, text. */
public sealed interface Content permits Element, Comment, Text {}
