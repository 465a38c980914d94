package org.robonewbie.pagejvm;

import org.jspecify.annotations.Nullable;

/** Methods that the interpreter executes without using their bytecode, such as those that wait. */
public interface SpecialCalls {

    /** Result for a method that is not replaced. */
    Object UNKNOWN = new Object();

    /** Replaces no calls. */
    SpecialCalls NONE = (owner, name, target, arguments) -> UNKNOWN;

    /**
     * Executes a call.
     *
     * @param owner internal name of the class in the instruction, such as {@code java/lang/Object}
     * @param name name of the method
     * @param target the receiver; null for a static method
     * @param arguments the arguments
     * @return the result, a {@link Waiting} if the call must wait for its result, or {@link #UNKNOWN}
     */
    @Nullable
    Object call(String owner, String name, @Nullable Object target, @Nullable Object[] arguments);
}
