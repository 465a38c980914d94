/**
 * The body of the NAO as SimSpark builds it: links, hinges and the five robot types. Read {@link
 * org.robonewbie.nao.model.NaoModel} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.model;
