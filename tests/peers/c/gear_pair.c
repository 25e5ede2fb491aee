/* The gear pair of Oh, Grosh & Barber (2005), written by hand in C for this one system, as fast as its author could.
 *
 *     gcc -O3 -o gear_pair gear_pair.c -lm && ./gear_pair 4500 10 1.0 200
 *
 * Arguments: speed of the driving gear [rpm], torque T0 [N m], end of the run [s], number of repetitions.
 * It prints the cell changes, the reflections, the cell at the end, theta above the lower end of that cell, theta', phi, phi',
 * and the least time of one event [ns].
 *
 * theta = (N1 theta1 + N2 theta2)/2, phi = (N1 theta1 - N2 theta2)/2. One tooth pitch is 2 pi in theta: k1 first, then k2.
 * In a cell of stiffness k, Eqs. (12), (13) of the paper with Rayleigh damping, r = M1/M2, x = phi - T0/k:
 *
 *     x = e^{-sigma t} (a cos wt + b sin wt)        theta = theta_0 + (theta'_0 - r phi'_0) t + r (x - a)
 *
 * One event: sin, cos and exp once, at the time that the mean speed gives; the time of the boundary by the reversed Taylor
 * series of theta; cos and sin there by the Taylor series of the small turn. There is no record, no energy account and no
 * compensation of rounding errors.
 *
 * Source: Oh, Grosh & Barber, "Energy Conserving Equations of Motion for Gear Systems", J. Vib. Acoust. 127(2), 2005,
 * doi:10.1115/1.1891815. Inertias are 10^3 times the printed kg mm^2 (a misprint in the paper).
 */
#define _GNU_SOURCE
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define PITCH 6.283185307179586
#define PI 3.141592653589793

/* Position and velocity; theta is counted from the lower end of the cell. */
typedef struct { double theta, theta_dot, phi, phi_dot; } State;
/* Constants of a cell: T0/k, M2 k, w, 1/w, extent in theta, M2 (k of the other cells - k), e^{-sigma pi/w}. */
typedef struct { double rest, w2, w, per_w, width, step, half_period; } Cell;
/* Constants of the pair: M1/M2, sigma, and its two cells. */
typedef struct { double ratio, sigma; Cell cells[2]; } Pair;
/* A motion in a cell: x = a C + b S, phi' = v C + q S, with C, S = e^{-sigma t} (cos wt, sin wt). */
typedef struct { double a, b, v, q, drift, theta; } Motion;
/* A time and C, S there. */
typedef struct { double t, c, s; } Point;
/* What became of a run. */
typedef struct { State end; long cell, changes, reflections; } Run;

static Pair pair(double t0) {
    const double i1 = 2.89e-3, i2 = 740.2e-3, n1 = 24, n2 = 96, width1 = 1.73, zeta = 0.05, k[2] = {1430, 2780};
    double m1 = (n1 * n1 / i1 - n2 * n2 / i2) / 2, m2 = (n1 * n1 / i1 + n2 * n2 / i2) / 2;
    Pair p = {.ratio = m1 / m2, .sigma = zeta * sqrt(m2 * (k[0] + k[1]) / 2)};
    for (int i = 0; i < 2; i++) {
        double w2 = m2 * k[i], w = sqrt(w2 - p.sigma * p.sigma);
        p.cells[i] = (Cell){t0 / k[i], w2, w, 1 / w, i ? PITCH - width1 : width1, m2 * (k[1 - i] - k[i]), exp(-p.sigma * PI / w)};
    }
    return p;
}

static inline Point at(const Pair *p, const Cell *c, double t) {
    double sine, cosine, decay = exp(-p->sigma * t);
    sincos(c->w * t, &sine, &cosine);
    return (Point){t, decay * cosine, decay * sine};
}

/* The state at a point, for the ends of runs and the search. */
static inline State state(const Pair *p, const Cell *c, const Motion *m, Point at) {
    double x = m->a * at.c + m->b * at.s, phi_dot = m->v * at.c + m->q * at.s;
    double theta = m->theta + (m->drift * at.t + p->ratio * (x - m->a));
    return (State){theta, m->drift + p->ratio * phi_dot, c->rest + x, phi_dot};
}

/* Goes from a point near it to where theta has changed by `distance`. Returns 0 if theta turns or passes `last` before that. */
static inline int meet(const Pair *p, const Cell *c, const Motion *m, double distance, double last, Point *at_) {
    double t = at_->t, C = at_->c, S = at_->s, sigma = p->sigma, r = p->ratio, way = 0;
    for (int i = 0; i < 50; i++) {
        double x = m->a * C + m->b * S, v = m->v * C + m->q * S;
        double acceleration = -2 * sigma * v - c->w2 * x, jerk = -2 * sigma * acceleration - c->w2 * v;
        double snap = -2 * sigma * jerk - c->w2 * acceleration;
        double lacking = distance - m->drift * t - r * (x - m->a), per_slope = 1 / (m->drift + r * v), h = lacking * per_slope;
        if (i == 0) way = per_slope;
        if (per_slope * way < 0 || t > last) return 0;
        /* The root of the Taylor polynomial of degree 4 by reversion where it is near, else Newton's step. */
        double g = r * per_slope * h, A = acceleration * 0.5 * g, B = jerk * (1. / 6) * g * h, D = snap * (1. / 24) * g * h * h;
        double A2 = A * A, next = A2 + fabs(B), dt = next < 1e-2 ? h * (1 - A + (2 * A2 - B) - (5 * A * (A2 - B) + D)) : h;
        t += dt;
        double y = c->w * dt, z = sigma * dt, y2 = y * y, z2 = z * z;
        if (y2 < 4e-4) {
            double cosine = 1 - y2 * (0.5 - y2 * (1. / 24 - y2 * (1. / 720)));
            double sine = y * (1 - y2 * (1. / 6 - y2 * (1. / 120 - y2 * (1. / 5040))));
            double decay = 1 - z + z2 * ((0.5 - z * (1. / 6)) + z2 * (1. / 24 - z * (1. / 120)));
            double turned = decay * (C * cosine - S * sine);
            S = decay * (S * cosine + C * sine), C = turned;
            if ((14 * next * next + fabs(D) * (fabs(y) + 6 * fabs(A))) * fabs(dt) <= DBL_EPSILON * t) break;
        } else if (y2 < 2e-2) {
            double cosine = 1 - y2 * (0.5 - y2 * (1. / 24 - y2 * (1. / 720 - y2 * (1. / 40320 - y2 * (1. / 3628800)))));
            double sine = y * (1 - y2 * (1. / 6 - y2 * (1. / 120 - y2 * (1. / 5040 - y2 * (1. / 362880)))));
            double decay = exp(-z), turned = decay * (C * cosine - S * sine);
            S = decay * (S * cosine + C * sine), C = turned;
        } else {
            Point there = at(p, c, t);
            C = there.c, S = there.s;
        }
    }
    *at_ = (Point){t, C, S};
    return 1;
}

/* The exit of a cell in which theta may turn: 1 upwards, -1 downwards, 0 if there is none until `left`.
 * Between zeros of theta'' theta bends one way: Newton's method from the one end, or from the other, never passes the root. */
static int search(const Pair *p, const Cell *c, const Motion *m, double left, Point *found) {
    double a = -2 * p->sigma * m->v - c->w2 * m->a, b = -(p->sigma * a + c->w2 * m->v) * c->per_w;
    double phase = atan2(-a, b);
    Point from = {0, 1, 0}, to = at(p, c, (phase <= 0 ? phase + PI : phase) * c->per_w);
    int bends = a > 0 || (a == 0 && b > 0) ? 1 : -1;
    State first = state(p, c, m, from);
    for (;;) {
        State last = state(p, c, m, to);
        double edge = bends < 0 ? c->width : 0, other = bends < 0 ? 0 : c->width;
        if (first.theta_dot * bends < 0) {
            /* Towards the edge, and back: no further than where the tangents at both ends meet. */
            double peak = (last.theta - first.theta - last.theta_dot * (to.t - from.t)) / (first.theta_dot - last.theta_dot);
            if ((first.theta + first.theta_dot * peak - edge) * bends < 0) {
                *found = from;
                if (meet(p, c, m, edge - m->theta, to.t, found)) return -bends;
            }
        }
        if ((last.theta - other) * bends > 0) {
            *found = to;
            if (meet(p, c, m, other - m->theta, INFINITY, found)) return bends;
        }
        if (to.t > left) return 0;
        from = to, first = last, bends = -bends;
        to = (Point){to.t + PI * c->per_w, -c->half_period * to.c, -c->half_period * to.s};
    }
}

static Run solve(const Pair *p, State now, double t_end) {
    Run run = {0};
    const double sigma = p->sigma, ratio = p->ratio;
    double left = t_end;
    for (;;) {
        /* Solve. */
        const Cell *c = &p->cells[run.cell & 1];
        double a = now.phi - c->rest, v = now.phi_dot;
        double b = (v + sigma * a) * c->per_w, q = -(sigma * v + c->w2 * a) * c->per_w, drift = now.theta_dot - ratio * v;
        Motion m = {a, b, v, q, drift, now.theta};
        /* Locate: in one step where |drift| exceeds all that phi' can add, else by the search. */
        Point exit;
        int up;
        if (drift * drift > 1.001 * ratio * ratio * (v * v + q * q)) {
            up = drift > 0 ? 1 : -1;
            double distance = (up > 0 ? c->width : 0) - now.theta;
            exit = at(p, c, distance / drift);
            meet(p, c, &m, distance, INFINITY, &exit);
        } else {
            up = search(p, c, &m, left, &exit);
        }
        if (!up || exit.t > left) {
            run.end = state(p, c, &m, at(p, c, left));
            return run;
        }
        left -= exit.t;
        /* Jump, Eqs. (9), (11); back where the energy does not suffice. */
        double phi = c->rest + (a * exit.c + b * exit.s), phi_dot = v * exit.c + q * exit.s;
        double theta_dot = drift + ratio * phi_dot, work = c->step * phi * phi, square = theta_dot * theta_dot - work;
        if (square < 0) {
            run.reflections++;
            now = (State){up > 0 ? c->width : 0, -theta_dot, phi, phi_dot - 2 * ratio * theta_dot};
            continue;
        }
        run.changes++;
        run.cell += up;
        double beyond = copysign(sqrt(square), theta_dot);
        now = (State){up > 0 ? 0 : p->cells[run.cell & 1].width, beyond, phi, phi_dot - ratio * work / (beyond + theta_dot)};
    }
}

static double clock_ns(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

int main(int n, char **words) {
    if (n != 5) {
        fprintf(stderr, "usage: gear_pair RPM T0 T_END REPETITIONS\n");
        return 2;
    }
    volatile double rpm = atof(words[1]);
    double t0 = atof(words[2]), t_end = atof(words[3]), least = INFINITY;
    Run run = {0};
    for (long i = atol(words[4]); i > 0; i--) {
        double begun = clock_ns();
        Pair p = pair(t0);
        run = solve(&p, (State){0, 24 * (rpm * PITCH / 60), t0 / 1430, 0}, t_end);
        least = fmin(least, clock_ns() - begun);
    }
    printf("%ld %ld %ld %.17g %.17g %.17g %.17g %.2f\n", run.changes, run.reflections, run.cell, run.end.theta, run.end.theta_dot,
           run.end.phi, run.end.phi_dot, least / (double)(run.changes + run.reflections));
    return 0;
}
