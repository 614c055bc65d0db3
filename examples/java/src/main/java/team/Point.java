package team;

import protos.Playmaker.RpcVector2D;

/** A position on the pitch in meters. Only + - * / and sqrt: every language computes the same bits. */
record Point(double x, double y) {
    /** The opponent's: every team attacks toward +x. */
    static final Point GOAL = new Point(52.5, 0);

    static Point of(RpcVector2D vector) {
        return new Point(vector.getX(), vector.getY());
    }

    double distance(Point other) {
        return length(x - other.x, y - other.y);
    }

    static double length(double dx, double dy) {
        return Math.sqrt(dx * dx + dy * dy);
    }

    static double clamp(double value, double low, double high) {
        return value < low ? low : value > high ? high : value;
    }
}
