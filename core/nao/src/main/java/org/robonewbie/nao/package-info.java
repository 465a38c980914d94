/** The basic facts about robot and pitch. Read {@link org.robonewbie.nao.Joint} first. */
@org.jspecify.annotations.NullMarked
package org.robonewbie.nao;
