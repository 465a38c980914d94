package org.robonewbie.studio.roboviz;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.robonewbie.nao.TeamSide;

/**
 * Parser of RoboViz's drawing protocol. Numbers are encoded as six ASCII characters, colours as three bytes, and strings as
 * zero-terminated UTF-8. As in RoboViz, the rest of a datagram is discarded after the first malformed command.
 */
final class RoboVizReader {

    /** Maximum size of a datagram; longer ones are truncated. */
    static final int MAX_DATAGRAM_BYTES = 512;

    private static final int NUMBER_BYTES = 6;
    private static final double MAX_COORDINATE = 1e4;
    private static final int RIGHT_TEAM = 128;
    private static final int MAX_PLAYERS = 11;
    private static final String[] SHAPES = {"circle", "line", "point", "sphere", "polygon"};
    private static final int[] NUMBERS = {4, 7, 4, 4};
    private static final int POLYGON = 4;

    private final ByteBuffer bytes;

    private RoboVizReader(ByteBuffer bytes) {
        this.bytes = bytes;
    }

    /** Returns all commands before the first malformed one. */
    static List<RoboVizCommand> read(byte[] datagram, int length) {
        RoboVizReader reader = new RoboVizReader(ByteBuffer.wrap(datagram, 0, Math.min(length, MAX_DATAGRAM_BYTES)));
        List<RoboVizCommand> commands = new ArrayList<>();
        try {
            while (reader.bytes.hasRemaining()) {
                commands.add(reader.command());
            }
        } catch (FaultyException rest) {
            return commands;
        }
        return commands;
    }

    private static final class FaultyException extends Exception {
        private static final long serialVersionUID = 1;
    }

    private RoboVizCommand command() throws FaultyException {
        int group = number8();
        int kind = number8();
        return switch (group) {
            case 0 -> kind == 0 ? new RoboVizCommand.Swap(text()) : faulty();
            case 1 -> kind < POLYGON ? shape(kind) : kind == POLYGON ? polygon() : faulty();
            case 2 -> writing(kind);
            case 3 -> kind == 0 ? selection() : faulty();
            default -> faulty();
        };
    }

    private static RoboVizCommand faulty() throws FaultyException {
        throw new FaultyException();
    }

    private RoboVizCommand shape(int kind) throws FaultyException {
        List<Double> numbers = numbers(NUMBERS[kind]);
        String colour = colour();
        return new RoboVizCommand.Draw(text(), SHAPES[kind], numbers, colour, 1, "");
    }

    private RoboVizCommand polygon() throws FaultyException {
        int corners = number8();
        String colour = colour();
        double opacity = number8() / 255.0;
        List<Double> numbers = numbers(3 * corners);
        return new RoboVizCommand.Draw(text(), SHAPES[POLYGON], numbers, colour, opacity, "");
    }

    private RoboVizCommand writing(int kind) throws FaultyException {
        switch (kind) {
            case 0 -> {
                List<Double> place = numbers(3);
                String colour = colour();
                String words = text();
                return new RoboVizCommand.Draw(text(), "text", place, colour, 1, words);
            }
            case 1 -> {
                int robot = robot();
                String colour = colour();
                return agentText(robot, colour, text());
            }
            case 2 -> {
                return agentText(robot(), "#ffffff", "");
            }
            default -> throw new FaultyException();
        }
    }

    private RoboVizCommand selection() throws FaultyException {
        robot();
        return new RoboVizCommand.Other();
    }

    private static RoboVizCommand agentText(int robot, String colour, String text) {
        TeamSide side = robot < RIGHT_TEAM ? TeamSide.LEFT : TeamSide.RIGHT;
        return new RoboVizCommand.AgentText(side, robot % RIGHT_TEAM + 1, colour, text);
    }

    private int robot() throws FaultyException {
        int robot = number8();
        if (robot % RIGHT_TEAM >= MAX_PLAYERS) {
            throw new FaultyException();
        }
        return robot;
    }

    private int number8() throws FaultyException {
        if (!bytes.hasRemaining()) {
            throw new FaultyException();
        }
        return bytes.get() & 0xff;
    }

    private List<Double> numbers(int count) throws FaultyException {
        List<Double> numbers = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            numbers.add(number());
        }
        return numbers;
    }

    private double number() throws FaultyException {
        if (bytes.remaining() < NUMBER_BYTES) {
            throw new FaultyException();
        }
        byte[] letters = new byte[NUMBER_BYTES];
        bytes.get(letters);
        try {
            double value = Double.parseDouble(new String(letters, StandardCharsets.US_ASCII).strip());
            if (Math.abs(value) <= MAX_COORDINATE) {
                return value;
            }
        } catch (NumberFormatException noNumber) {
            throw new FaultyException();
        }
        throw new FaultyException();
    }

    private String colour() throws FaultyException {
        return String.format(Locale.ROOT, "#%02x%02x%02x", number8(), number8(), number8());
    }

    private String text() throws FaultyException {
        ByteArrayOutputStream letters = new ByteArrayOutputStream();
        for (int letter = number8(); letter != 0; letter = number8()) {
            letters.write(letter);
        }
        return letters.toString(StandardCharsets.UTF_8);
    }
}
