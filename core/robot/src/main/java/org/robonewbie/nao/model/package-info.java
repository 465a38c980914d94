/**
 * SimSpark's model of the NAO: links, hinges and the five robot types. Read {@link org.robonewbie.nao.model.NaoModel} first.
 */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao.model;
