package org.robonewbie.web.compiling;

import java.lang.reflect.Modifier;
import java.util.Set;
import org.teavm.extension.introspect.IntrospectMember;
import org.teavm.extension.spi.reflection.SimpleReflectionPolicy;

/** Keeps in the compiled program, with its name, whatever a student's program may call. */
public final class ProgramsCall extends SimpleReflectionPolicy {

    /** Set while the part of the page is compiled that runs no programs of students. */
    static final boolean WITHOUT_PROGRAMS = Boolean.getBoolean("robonewbie.withoutPrograms");

    /** What begins a simulator, which the page carries out in another way, and what makes threads wait for each other. */
    private static final Set<String> OTHERWISE =
            Set.of("Nao.connect", "Agent.run", "Agent.runTogether", "Object.wait", "Object.notify", "Object.notifyAll");

    /** All that programs may ask a class for; some of its other methods are translated wrongly by TeaVM 0.15.0. */
    private static final Set<String> OF_CLASS =
            Set.of("getName", "getSimpleName", "isInstance", "toString", "desiredAssertionStatus");

    /** Where TeaVM's library, which is of Java 21, declares what Java 17 declares in {@code Deque}, {@code List} and their like. */
    private static final Set<String> SEQUENCED =
            Set.of("java.util.SequencedCollection", "java.util.SequencedSet", "java.util.SequencedMap");

    /** Creates the policy; TeaVM finds it by its name. */
    public ProgramsCall() {}

    @Override
    protected void setup() {
        selectClasses(type -> !WITHOUT_PROGRAMS && isOfPrograms(type.name()))
                .foundByName()
                .reflectableMembers(ProgramsCall::isCallable);
    }

    private static boolean isOfPrograms(String name) {
        return ProgramLibrary.has(name) || SEQUENCED.contains(name);
    }

    private static boolean isCallable(IntrospectMember member) {
        boolean isOfClass = member.declaringClass().name().equals("java.lang.Class");
        return PUBLIC.test(member)
                && (!isOfClass || OF_CLASS.contains(member.name()))
                && !Modifier.isNative(member.modifiers())
                && !OTHERWISE.contains(member.declaringClass().simpleName() + "." + member.name());
    }
}
