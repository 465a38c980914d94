package org.robonewbie.pagejvm;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/** An object of a student's class, whatever Java class stands for it. */
interface StudentObject {

    /** {@return its class} */
    StudentClass type();

    /** {@return the machine in which it lives} */
    Machine machine();

    /** {@return its fields, by class and name} */
    Map<String, @Nullable Object> fields();

    /**
     * Calls what a compiled class above says, as {@code super} does.
     *
     * @param member the method
     * @param arguments its arguments
     * @return its result
     */
    @Nullable
    Object callSuper(ClassFile.Member member, @Nullable Object[] arguments);

    /**
     * Reads a field of a compiled class above.
     *
     * @param name of the field
     * @return its value
     */
    default Object inheritedField(String name) {
        throw new Missing(type() + " inherits no field " + name);
    }
}
