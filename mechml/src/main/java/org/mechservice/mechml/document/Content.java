package org.mechservice.mechml.document;

/** Content of an element: child elements and comments. */
public sealed interface Content permits Element, Comment {}
