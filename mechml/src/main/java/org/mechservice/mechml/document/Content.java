package org.mechservice.mechml.document;

/** Content of an element: child elements, comments, and the text of a file that travels with it. */
public sealed interface Content permits Element, Comment, Text {}
