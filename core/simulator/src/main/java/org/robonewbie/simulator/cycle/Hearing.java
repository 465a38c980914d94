package org.robonewbie.simulator.cycle;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.perceptor.Heard;

/**
 * A robot's hear perceptor. In each cycle it receives at most the robot's own message, one message from a teammate and
 * one from an opponent. After a message from a teammate or an opponent, it receives no message of that kind in the next
 * cycle (SimSpark: {@code agentstate.cpp}).
 */
final class Hearing implements Restorable {

    private static final int CAPACITY = 2;

    private final Ear teamMates = new Ear();
    private final Ear opponents = new Ear();
    private Optional<Message> own = Optional.empty();

    private record Message(String team, OptionalDouble directionDegrees, String text) {

        void save(StateWriter out) {
            out.putText(team);
            out.putBoolean(directionDegrees.isPresent());
            out.putDouble(directionDegrees.orElse(0));
            out.putText(text);
        }

        static Message restore(StateReader in) {
            String team = in.getText();
            boolean directed = in.getBoolean();
            double degrees = in.getDouble();
            return new Message(team, directed ? OptionalDouble.of(degrees) : OptionalDouble.empty(), in.getText());
        }
    }

    void hearOwn(String team, String text) {
        own = Optional.of(new Message(team, OptionalDouble.empty(), text));
    }

    void hear(boolean fromTeamMate, String team, double directionDegrees, String text) {
        (fromTeamMate ? teamMates : opponents).hear(new Message(team, OptionalDouble.of(directionDegrees), text));
    }

    /** Removes and returns the messages of this cycle. */
    List<Heard> collect(double playSeconds, boolean labelled) {
        Optional<Message> said = own;
        own = Optional.empty();
        Optional<Message> ofMate = teamMates.collect();
        Optional<Message> ofOpponent = opponents.collect();
        return said.isEmpty() && ofMate.isEmpty() && ofOpponent.isEmpty()
                ? List.of()
                : Stream.of(said, ofMate, ofOpponent)
                        .flatMap(Optional::stream)
                        .map(message -> heard(message, playSeconds, labelled))
                        .toList();
    }

    private static Heard heard(Message message, double playSeconds, boolean labelled) {
        Optional<String> team = labelled ? Optional.of(message.team()) : Optional.empty();
        return new Heard(team, playSeconds, message.directionDegrees(), message.text());
    }

    @Override
    public void save(StateWriter out) {
        out.putOptional(own, message -> message.save(out));
        teamMates.save(out);
        opponents.save(out);
    }

    @Override
    public void restore(StateReader in) {
        own = in.getOptional(() -> Message.restore(in));
        teamMates.restore(in);
        opponents.restore(in);
    }

    private static final class Ear {

        private int capacity = CAPACITY;
        private Optional<Message> message = Optional.empty();

        void hear(Message newMessage) {
            if (capacity >= CAPACITY) {
                capacity = 0;
                message = Optional.of(newMessage);
            }
        }

        Optional<Message> collect() {
            Optional<Message> collected = message;
            message = Optional.empty();
            capacity = Math.min(CAPACITY, capacity + 1);
            return collected;
        }

        void save(StateWriter out) {
            out.putInt(capacity);
            out.putOptional(message, words -> words.save(out));
        }

        void restore(StateReader in) {
            capacity = in.getInt();
            message = in.getOptional(() -> Message.restore(in));
        }
    }
}
