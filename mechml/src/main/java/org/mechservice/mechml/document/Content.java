package org.mechservice.mechml.document;

/** What stands between the tags of an element. */
public sealed interface Content permits Element, Comment {}
