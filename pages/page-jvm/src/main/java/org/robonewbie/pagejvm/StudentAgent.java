package org.robonewbie.pagejvm;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.running.ThinkSpelling;

/** Instance of a student's agent class: the framework runs the cycle, and the machine executes its steps. */
final class StudentAgent extends Agent implements StudentObject {

    private static final String STEP = "()V";

    private final StudentClass type;
    private final Machine machine;
    private final Map<String, @Nullable Object> fields;

    StudentAgent(StudentClass type, Machine machine) {
        this.type = type;
        this.machine = machine;
        fields = type.newFields();
        ThinkSpelling.problemAmong(type.headings(), type.simpleName()).ifPresent(machine.output()::println);
    }

    @Override
    public StudentClass type() {
        return type;
    }

    @Override
    public Machine machine() {
        return machine;
    }

    @Override
    public Map<String, @Nullable Object> fields() {
        return fields;
    }

    @Override
    protected Options defaults() {
        Optional<StudentMethod> own = type.find("defaults()Lorg/robonewbie/agent/Options;");
        return own.isPresent() ? (Options) Objects.requireNonNull(machine.call(own.get(), this)) : super.defaults();
    }

    @Override
    protected void sense() {
        machine.newCycle();
        type.find("sense" + STEP).ifPresentOrElse(own -> machine.call(own, this), super::sense);
    }

    @Override
    protected void think() {
        type.find("think" + STEP).ifPresentOrElse(own -> machine.call(own, this), super::think);
    }

    @Override
    protected void act() {
        type.find("act" + STEP).ifPresentOrElse(own -> machine.call(own, this), super::act);
    }

    @Override
    public Object inheritedField(String name) {
        return switch (name) {
            case "log" -> log;
            case "nao" -> nao;
            case "motions" -> motions;
            case "walk" -> walk;
            case "fieldView" -> fieldView;
            case "lookAround" -> lookAround;
            default -> StudentObject.super.inheritedField(name);
        };
    }

    @Override
    public @Nullable Object callSuper(ClassFile.Member member, @Nullable Object[] arguments) {
        switch (member.name()) {
            case "<init>" -> {}
            case "sense" -> super.sense();
            case "think" -> super.think();
            case "act" -> super.act();
            case "defaults" -> {
                return super.defaults();
            }
            default -> {
                return inherited(member.name(), arguments);
            }
        }
        return null;
    }

    /** Calls a method inherited from {@code Agent}. */
    @Nullable
    Object inherited(String name, @Nullable Object[] arguments) {
        switch (name) {
            case "number" -> {
                return number(
                        (String) Objects.requireNonNull(arguments[0]),
                        (Double) Objects.requireNonNull(arguments[1]),
                        (Double) Objects.requireNonNull(arguments[2]),
                        (Double) Objects.requireNonNull(arguments[3]));
            }
            case "options" -> {
                return options();
            }
            case "leaveGame" -> leaveGame();
            case "sense", "think", "act", "defaults" -> {
                return callSuper(new ClassFile.Member("", name, ""), arguments);
            }
            default -> {
                return SpecialCalls.UNKNOWN;
            }
        }
        return null;
    }
}
