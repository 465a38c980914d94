package org.robonewbie.protocol.order;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpReader;

/**
 * Parses commands from a trainer. Unknown and incomplete commands are ignored silently, as in rcssserver3d.
 *
 * <p>Source: SimSpark's {@code trainercommandparser.cpp}.
 */
public final class TrainerOrderReader {

    /** Maximum magnitude of a coordinate in metres or a velocity in metres per second. */
    private static final double MAX_COORDINATE = 1e5;

    private final SexpReader in = SexpReader.withQuotes();

    /** Creates a reader. */
    public TrainerOrderReader() {}

    /**
     * Parses all commands in a message.
     *
     * @param message the message from a monitor
     * @return the commands in order
     */
    public List<Order.Trainer> read(MessageBuffer message) {
        List<Order.Trainer> orders = new ArrayList<>();
        in.start(message);
        while (in.nextList(0)) {
            TrainerExpression.read(in).ifPresent(expression -> translate(expression, orders::add));
        }
        return orders;
    }

    private static void translate(TrainerExpression command, Consumer<Order.Trainer> out) {
        switch (command.name()) {
            case "kickOff" -> readKickOff(command).ifPresent(out);
            case "playMode" ->
                command.word()
                        .flatMap(PlayMode::ofSimSparkName)
                        .map(Order.ChangePlayMode::new)
                        .ifPresent(out);
            case "dropBall" -> out.accept(new Order.DropBall());
            case "ball" -> readBall(command).ifPresent(out);
            case "agent" -> readAgent(command, out);
            case "select" -> readSelect(command, out);
            case "kill" -> readPlayer(command, Order.KillRobot::new).ifPresent(out);
            case "repos" -> readPlayer(command, Order.RepositionRobot::new).ifPresent(out);
            case "killsim" -> out.accept(new Order.EndSimulation());
            case "reqfullstate" -> out.accept(new Order.RequestFullState());
            case "time" -> readTime(command).ifPresent(out);
            case "score" -> readScore(command).ifPresent(out);
            default -> {
                // rcssserver3d ignores unknown commands, and monitors rely on that
            }
        }
    }

    private static Optional<Order.Trainer> readKickOff(TrainerExpression command) {
        return command.word()
                .filter(word -> word.equals("None") || side(word).isPresent())
                .map(word -> new Order.KickOff(side(word)));
    }

    private static Optional<Order.Trainer> readBall(TrainerExpression command) {
        Optional<Vector3> position = vector(command, "pos", 3);
        Optional<Vector3> velocity = vector(command, "vel", 3);
        return position.isEmpty() && velocity.isEmpty()
                ? Optional.empty()
                : Optional.of(new Order.MoveBall(position, velocity));
    }

    private static void readAgent(TrainerExpression command, Consumer<Order.Trainer> out) {
        if (command.numbers("unum").isEmpty() || command.words("team").isEmpty()) {
            out.accept(new Order.RepelSelectedRobot());
            return;
        }
        player(command).ifPresent(player -> {
            vector(command, "pos", 3)
                    .map(position -> new Order.MoveRobot(player, position))
                    .ifPresent(out);
            vector(command, "move", 4)
                    .map(position -> new Order.MoveAndTurnRobot(
                            player, position, command.numbers("move").get(3)))
                    .ifPresent(out);
        });
    }

    private static void readSelect(TrainerExpression command, Consumer<Order.Trainer> out) {
        List<Double> number = command.numbers("unum");
        if (number.isEmpty()) {
            out.accept(new Order.SelectNextRobot());
        } else if (number.get(0) < 0) {
            out.accept(new Order.SelectNoRobot());
        } else {
            player(command).map(Order.SelectRobot::new).ifPresent(out);
        }
    }

    /**
     * Creates the command for the robot specified in the expression, or for the selected robot if the number or the
     * team is missing. Returns empty if the team is unknown.
     */
    private static Optional<Order.Trainer> readPlayer(
            TrainerExpression command, Function<Optional<PlayerNumber>, Order.Trainer> create) {
        if (command.numbers("unum").isEmpty() || command.words("team").isEmpty()) {
            return Optional.of(create.apply(Optional.empty()));
        }
        return player(command).map(player -> create.apply(Optional.of(player)));
    }

    private static Optional<Order.Trainer> readTime(TrainerExpression command) {
        return command.number()
                .filter(time -> time >= 0 && Double.isFinite(time))
                .map(Order.SetTime::new);
    }

    private static Optional<Order.Trainer> readScore(TrainerExpression command) {
        List<Double> left = command.numbers("left");
        List<Double> right = command.numbers("right");
        return left.isEmpty() || right.isEmpty() || left.get(0) < 0 || right.get(0) < 0
                ? Optional.empty()
                : Optional.of(
                        new Order.SetScore(left.get(0).intValue(), right.get(0).intValue()));
    }

    private static Optional<PlayerNumber> player(TrainerExpression command) {
        Optional<Integer> number =
                command.numbers("unum").stream().map(Double::intValue).findFirst();
        Optional<TeamSide> team = command.words("team").stream().findFirst().flatMap(TrainerOrderReader::side);
        return number.flatMap(value -> team.map(side -> new PlayerNumber(side, value)));
    }

    private static Optional<TeamSide> side(String word) {
        return switch (word) {
            case "Left" -> Optional.of(TeamSide.LEFT);
            case "Right" -> Optional.of(TeamSide.RIGHT);
            default -> Optional.empty();
        };
    }

    private static Optional<Vector3> vector(TrainerExpression command, String name, int count) {
        List<Double> numbers = command.numbers(name);
        boolean valid =
                numbers.size() == count && numbers.stream().allMatch(number -> Math.abs(number) <= MAX_COORDINATE);
        return valid ? Optional.of(new Vector3(numbers.get(0), numbers.get(1), numbers.get(2))) : Optional.empty();
    }
}
