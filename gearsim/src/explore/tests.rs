//! Tests of the explorer and its server.
